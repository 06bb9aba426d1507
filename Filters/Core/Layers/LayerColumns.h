// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/LayerCells.h"

#include <array>
#include <vector>

namespace insideout
{
/**
 * The corners of a triangle of the wall and the inner ends of its layers; equal where there is
 * none.
 */
struct LayerColumn
{
  std::array<Point, 3> Outer; ///< counter-clockwise seen from outside
  std::array<Point, 3> Inner;
};

/** The point on the border of a layer: exactly the ends for 0 and 1. */
template <std::size_t Axes>
std::array<double, Axes> PlaceOnBorder(
  const std::array<double, Axes>& outer, const std::array<double, Axes>& inner, double fraction)
{
  if (fraction <= 0 || fraction >= 1)
  {
    return fraction <= 0 ? outer : inner;
  }
  std::array<double, Axes> place;
  for (std::size_t k = 0; k < Axes; ++k)
  {
    place[k] = outer[k] + fraction * (inner[k] - outer[k]);
  }
  return place;
}

/**
 * Whether all cells of a column are positive at their corners, exactly: a prism, or the pyramid or
 * tetrahedron that it becomes if one or two edges have no length.
 */
bool IsPositive(const LayerColumn& column, const std::vector<double>& fractions);
} // namespace insideout
