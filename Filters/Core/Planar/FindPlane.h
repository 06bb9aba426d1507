// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/PlanarPoint.h"
#include "Common/Types.h"

#include <vector>

namespace insideout
{
/**
 * The largest distance from a plane, relative to the largest coordinate, that counts as rounding:
 * coordinates may have been rotated or moved in double or in single precision.
 */
constexpr double RoundingOfDoubles = 0x1p-50;
constexpr double RoundingOfSingles = 0x1p-22;

/**
 * A plane with two coordinates: two of the points' three, along which the plane is least steep,
 * times a power of two. This keeps every bit of a point and straight lines straight, so exact
 * predicates of the coordinates hold in the plane. The metric restores lengths and angles.
 */
struct Plane
{
  int Dropped;             ///< the omitted axis
  std::array<int, 2> Axes; ///< metric of the two coordinates
  int Exponent;            ///< coordinates are scaled by 2 to the power of minus this, and below 1
  Point Normal;            ///< of length 1; seen from its side the axes run counter-clockwise
  Point Origin;            ///< a point of the plane, scaled likewise
  PlanarMetric Metric;
  /// largest distance of a point from the plane, relative to the largest coordinate; 0: exact
  double Distance;

  /** The coordinates of a point in the plane. */
  PlanarPoint Project(const Point& p) const;

  /** The point of the plane with these coordinates. */
  Point Lift(const PlanarPoint& p) const;

  /** The projection of a point onto the plane, up to rounding. */
  Point Foot(const Point& p) const;

  /** The same plane with the opposite normal. */
  Plane Turned() const;
};

/**
 * The plane of three points that are far from each other; its normal's component along the omitted
 * axis is positive. Among axes whose components differ by rounding alone the first is omitted, so
 * rounded points of the plane have the same axes. Distance tells whether all points lie in it: it
 * is 0 if they do exactly.
 *
 * @throws Error EmptySurface, AllDegenerate if all points lie on one line
 */
Plane FindPlane(const std::vector<Point>& points);
} // namespace insideout
