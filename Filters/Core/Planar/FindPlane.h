// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/PlanarPoint.h"
#include "Common/Types.h"

#include <vector>

namespace insideout
{
/**
 * How far points may be from a plane, as a part of the largest coordinate, for that to be rounding:
 * of coordinates that were ever turned or moved, in double or in single precision.
 */
constexpr double RoundingOfDoubles = 0x1p-50;
constexpr double RoundingOfSingles = 0x1p-22;

/**
 * A plane, and two coordinates for what is in it: two of the three that points have, those along
 * which the plane is least steep, times a power of two. So every bit of a point is kept, what is
 * straight stays straight, and exact answers about the coordinates hold in the plane. What they
 * change, lengths and angles, the metric gives back.
 */
struct Plane
{
  int Dropped;             ///< the axis whose coordinate is left out
  std::array<int, 2> Axes; ///< of the two coordinates
  int Exponent;            ///< they are times two to the power of minus this, and below 1
  Point Normal;            ///< of length 1; seen from its side the axes run counter-clockwise
  Point Origin;            ///< a point of the plane, times that power, too
  PlanarMetric Metric;
  double Distance; ///< of the farthest point from the plane, over the largest coordinate; 0: exact

  /** The coordinates of a point in the plane. */
  PlanarPoint Project(const Point& p) const;

  /** The point of the plane that has these coordinates. */
  Point Lift(const PlanarPoint& p) const;

  /** The point of the plane nearest to another, but for rounding. */
  Point Foot(const Point& p) const;

  /** The same plane seen from the other side. */
  Plane Turned() const;
};

/**
 * The plane of three of the points that are far from each other, seen from where its normal's
 * largest component is positive. Whether all points lie in it is for Distance to tell: it is 0
 * where they do exactly.
 *
 * @throws Error EmptySurface, AllDegenerate where all points lie on one line
 */
Plane FindPlane(const std::vector<Point>& points);
} // namespace insideout
