// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Edge.h"
#include "Common/Types.h"

#include <optional>
#include <vector>

namespace insideout
{
/** An edge of an outline, and its signed count from the lower to the higher end. */
struct OutlineEdge
{
  Edge Ends;
  int Count;
};

/** Triangles whose boundary is an outline. */
struct EnclosedTriangles
{
  std::vector<Triangle> Triangles; ///< no triangles, because there are too many crossings
  bool IsCrossed = false; ///< two edges cross, so that triangles overlap or cover outside space
};

/**
 * The triangles that an outline encloses, seen along an axis: those of a constrained Delaunay
 * triangulation, each repeated by its winding number. Up to ids, the result does not depend on the
 * order of points and edges.
 *
 * If a point lies on an edge, the degenerate triangle of all three is inserted between the edge and
 * its parts. If edges cross, one takes a detour via an end of the other, and triangles overlap.
 * Between points that differ only along the axis there are upright triangles.
 *
 * @param[in] points no two of them equal
 * @param[in] outline not empty; equally many edges begin and end at each point
 * @return nothing if all points project to a line
 */
std::optional<EnclosedTriangles> TriangulateEnclosed(
  const std::vector<Point>& points, const std::vector<OutlineEdge>& outline, int axis);
} // namespace insideout
