// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <vector>

namespace insideout
{
/**
 * The worst shape (ShapeOf) of the cells between a point and walls around it, which are
 * counter-clockwise seen from it.
 * @param[in] enough if the shape is below this, any smaller value may be returned
 */
double WorstShapeAt(const std::vector<Point>& points, const std::vector<Triangle>& walls,
  const Point& place, double enough);

/**
 * Move a point to improve the worst shape of the cells between it and the walls. Steps follow the
 * shortest vector between the gradients of the worst cells' shapes (Freitag and Ollivier-Gooch
 * 1997, Tetrahedral Mesh Improvement Using Swapping and Smoothing).
 *
 * @param[in,out] place the point, which may start beyond walls
 * @param[in] normal of the plane that it stays in, of length 1; null: none
 * @return the worst shape there
 */
double FindBestPlace(const std::vector<Point>& points, const std::vector<Triangle>& walls,
  Point& place, const Point* normal = nullptr);
} // namespace insideout
