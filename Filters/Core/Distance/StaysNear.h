// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Distance/SurfaceDistance.h"

namespace insideout
{
/**
 * Whether no point of a tetrahedron is farther from a surface than `most`, up to rounding.
 *
 * The distance from one facet is convex, so the corners of a piece of the tetrahedron bound all of
 * it. If not all corners are near the facet nearest to the piece's center, the piece is cut in two:
 * by a wall on an edge of this facet, or else at the midpoint of its longest edge.
 *
 * @param[in] facets of the surface
 * @param[in] distances of these
 * @return false also if more than 4,096 pieces are needed
 */
bool StaysNear(const std::array<Point, 4>& tetrahedron, const std::vector<Point>& points,
  const std::vector<Triangle>& facets, const SurfaceDistance& distances, double most);
} // namespace insideout
