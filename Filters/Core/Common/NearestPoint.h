// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Box.h"

namespace insideout
{
/** The point of a triangle nearest to a query point; the triangle may be degenerate. */
Point NearestPointOf(const std::array<Point, 3>& triangle, const Point& place);

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
