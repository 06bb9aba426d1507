// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace insideout
{
/**
 * How near two points, a point and an edge, or layers are at most taken for one: some spacings of
 * the doubles, because what lies nearer makes slivers that cross again. Three times that in each
 * round stays below 1e-12 of the largest coordinate.
 */
inline double SnappingRadius(double largestCoordinate)
{
  return std::ldexp(largestCoordinate, -45);
}
} // namespace insideout
