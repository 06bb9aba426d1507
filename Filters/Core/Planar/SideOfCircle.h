// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/PlanarPoint.h"

namespace insideout
{
/** Circles of a metric, by its squared lengths xx dx dx + 2 xy dx dy + yy dy dy; exactly. */
class SideOfCircle
{
public:
  explicit SideOfCircle(const PlanarMetric& metric = PlanarMetric());

  /**
   * The position of d relative to the circle through a, b, c, which run counter-clockwise: 1
   * inside, 0 on it.
   */
  int operator()(
    const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c, const PlanarPoint& d) const;

private:
  template <typename Number>
  int Sign(const std::array<const PlanarPoint*, 4>& points) const;

  bool IsRound; ///< with this metric circles are those of the coordinates
  double XX;
  double XY;
  double YY;
};
} // namespace insideout
