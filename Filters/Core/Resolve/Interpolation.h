// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

namespace insideout
{
/**
 * Barycentric weights of a point in a triangle. They are those of the point itself if it lies in
 * the triangle, seen along the axis nearest to the normal; else those of the nearest point on an
 * edge. All are in [0, 1], and they sum to 1.
 *
 * @param[in] triangle not degenerate
 * @param[in] p in the triangle up to rounding
 */
std::array<double, 3> BarycentricWeights(const std::array<Point, 3>& triangle, const Point& p);
} // namespace insideout
