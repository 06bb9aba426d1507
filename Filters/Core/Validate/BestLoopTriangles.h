// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <optional>

namespace insideout
{
/** Limit of corners: longer loops take longer than a Delaunay triangulation does. */
constexpr int MostCornersToSearch = 16;

/** A loop of points in space, possibly with repeated points. */
struct SmallLoop
{
  const Point* Corners; ///< coordinates for orientation predicates
  const Point* Scaled;  ///< the same times a power of two, so that products of four do not overflow
  int Size;             ///< from 3 to MostCornersToSearch
};

/** Triangles whose boundary is a loop. */
struct LoopTriangles
{
  double Area;                                                     ///< twice the area, scaled
  std::array<std::array<int, 3>, MostCornersToSearch - 2> Corners; ///< Size - 2 of them
};

/**
 * The triangulation of a loop that has the least area. Among triangulations of equal area, up to
 * `margin`, it has the least sum of (a^2 + b^2 + c^2) / area over triangles with edges a, b and c.
 * In a plane that is the constrained Delaunay one (Musin 1997, Properties of the Delaunay
 * triangulation). By dynamic programming (Klincsek 1980, Minimal triangulations of polygonal
 * domains; Barequet and Sharir 1995, Filling gaps in the boundary of a polyhedron).
 *
 * @param[in] sign if not 0, each triangle must have exactly this orientation seen along the axis;
 * they then cover each place as often as the loop winds around it
 * @param[in] margin twice an area, scaled
 * @return nothing if there is none
 */
std::optional<LoopTriangles> FindBestLoopTriangles(
  const SmallLoop& loop, int axis, int sign, double margin);
} // namespace insideout
