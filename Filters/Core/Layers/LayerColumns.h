// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/LayerCells.h"

#include <vector>

namespace insideout
{
/** Where the borders of layers are between the wall and the innermost one: 0, and up to 1. */
std::vector<double> FractionsOfLayers(int layers, double growth);

/** The corners of a triangle of the wall and the ends of the layers behind them; equal where there
 * is none. */
struct LayerColumn
{
  std::array<Point, 3> Outer; ///< counter-clockwise seen from outside
  std::array<Point, 3> Inner;
};

/** The point on the border of a layer: exactly the ends for 0 and 1. */
Point PlaceOnBorder(const Point& outer, const Point& inner, double fraction);

/**
 * Whether all cells of a column are positive at their corners, exactly: a prism at all six; a
 * pyramid and a tetrahedron, which it becomes where one or two edges have no length, at all of
 * theirs.
 */
bool IsPositive(const LayerColumn& column, const std::vector<double>& fractions);
} // namespace insideout
