// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <cmath>

namespace insideout
{
/**
 * The j-th of a fixed sequence of places in a box, none near its sides. Their coordinates are
 * irregular, off the planes that people draw.
 *
 * @param[in] spread fraction of the box, about its center, that they are in
 */
inline Point PlaceInBox(const Point& low, const Point& high, int j, double spread = 0.8)
{
  // Additive recurrence with the powers of the plastic number, which fills a cube evenly.
  const Point step = { 0.8191725133961645, 0.6710436067037893, 0.5497004779019703 };
  Point place;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double x = 0.5 + (j + 1) * step[axis];
    const double part = 0.5 + spread * (x - std::floor(x) - 0.5);
    place[axis] = low[axis] + part * (high[axis] - low[axis]);
  }
  return place;
}
} // namespace insideout
