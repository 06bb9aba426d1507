// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Box.h"

namespace insideout
{
/** The point of a triangle nearest to a query point; the triangle may be degenerate. */
Point NearestPointOf(const std::array<Point, 3>& triangle, const Point& place);

/** The squared distances of many places from one triangle, which may be degenerate. */
class SquaredDistances
{
public:
  explicit SquaredDistances(const std::array<Point, 3>& triangle);

  /** The squared distance from the nearest point, up to rounding; if it is at least `most`, any
   * number from `most` on. */
  double To(const Point& place, double most) const;

private:
  std::array<Point, 3> Corners;
  bool IsNeedle;                        ///< doubles do not determine the normal well
  Point Normal;                         ///< of length 1
  std::array<Point, 3> Slopes;          ///< gradients of the barycentric coordinates
  std::array<Point, 3> Edges;           ///< from each corner to the next
  std::array<double, 3> Inverses;       ///< of their squared lengths
  std::array<double, 3> SquaredHeights; ///< of the corners above the opposite edges
};

/** The vector from a box to a query point; 0 in the box. */
inline double SquaredDistance(const Box& box, const Point& place)
{
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double beyond =
      std::max({ box.Low[axis] - place[axis], place[axis] - box.High[axis], 0.0 });
    sum += beyond * beyond;
  }
  return sum;
}
} // namespace insideout
