// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/LayerCells.h"

#include <vector>

namespace insideout
{
/**
 * The positions of the borders of layers, as fractions of the way from the wall: 0, and up to 1.
 */
std::vector<double> FractionsOfLayers(int layers, double growth);

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
Point PlaceOnBorder(const Point& outer, const Point& inner, double fraction);

/**
 * Whether all cells of a column are positive at their corners, exactly: a prism, or the pyramid or
 * tetrahedron that it becomes if one or two edges have no length.
 */
bool IsPositive(const LayerColumn& column, const std::vector<double>& fractions);
} // namespace insideout
