// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "WindingNumber/CountedBoundary.h"

namespace insideout
{
/**
 * For each cell, 1 where one of the triangles may touch it: where its box meets the triangle's box
 * and its corners are not clearly on one side of the triangle's plane. A cell with 0 certainly has
 * no point in common with any of them.
 *
 * @param[in] points of cells and triangles, below 1 in each coordinate
 * @param[in] groups of triangles
 */
std::vector<char> TouchedCells(const std::vector<Point>& points,
  const std::vector<Tetrahedron>& cells, const std::vector<std::vector<CountedTriangle>>& groups);
} // namespace insideout
