// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Distance/SurfaceDistance.h"

namespace insideout
{
/**
 * Whether no point of a tetrahedron is farther from a surface than `most`, as far as rounding
 * tells.
 *
 * The distance from one facet is convex, so that the corners of a piece of the tetrahedron tell of
 * all of it. Where not all of them are near the facet that is nearest to the piece's center the
 * piece is cut in two: by a wall that stands on an edge of this facet, or else in the middle of its
 * longest edge.
 *
 * @param[in] facets of the surface
 * @param[in] distances of these
 * @return false also where that takes more than 4,096 pieces
 */
bool StaysNear(const std::array<Point, 4>& tetrahedron, const std::vector<Point>& points,
  const std::vector<Triangle>& facets, const SurfaceDistance& distances, double most);
} // namespace insideout
