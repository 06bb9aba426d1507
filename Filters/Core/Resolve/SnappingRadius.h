// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace insideout
{
/**
 * The distance up to which two points, a point and an edge, or layers are merged: some spacings of
 * the doubles, because smaller distances make slivers that cross again. Three times that in each
 * round stays below 1e-12 of the largest coordinate.
 */
inline double SnappingRadius(double largestCoordinate)
{
  return std::ldexp(largestCoordinate, -45);
}

/** The limit of the distance of a piece from its facet after all rounds. */
inline double LargestShift(double largestCoordinate)
{
  return 1e-12 * largestCoordinate;
}
} // namespace insideout
