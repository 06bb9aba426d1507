// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Edge.h"
#include "Common/Types.h"

#include <optional>
#include <vector>

namespace insideout
{
/** An edge of an outline, and how often more it runs from the lower end than from the higher. */
struct OutlineEdge
{
  Edge Ends;
  int Count;
};

/** Triangles whose boundary is an outline. */
struct EnclosedTriangles
{
  std::vector<Triangle> Triangles; ///< none where crossings take too many
  bool IsCrossed = false; ///< two edges cross, so that triangles overlap or cover what is outside
};

/**
 * The triangles that an outline encloses, seen along an axis: those of a constrained Delaunay
 * triangulation, each as often as the winding number there says. It does not depend on the order of
 * points and edges but by the ids that it gives.
 *
 * Where a point lies on an edge the triangle of all three, which is degenerate, stands between the
 * edge and its parts. Where edges cross, one goes around through an end of the other, and triangles
 * overlap. Where points differ only along the axis, triangles stand upright between them.
 *
 * @param[in] points no two of them equal
 * @param[in] outline not empty; as many edges begin as end at each point
 * @return nothing where all points are seen on a line
 */
std::optional<EnclosedTriangles> TriangulateEnclosed(
  const std::vector<Point>& points, const std::vector<OutlineEdge>& outline, int axis);
} // namespace insideout
