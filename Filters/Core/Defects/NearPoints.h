// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <vector>

namespace insideout
{
/** Points that may be meant to coincide. */
struct NearPoints
{
  Id Count = 0;        ///< number of points with another one nearer than Distance
  double Distance = 0; ///< in units of the surface
};

/**
 * Count the points that lie nearer to another one than `fraction` of the diagonal of their bounding
 * box. Subject to rounding: the result is only advice.
 *
 * @param[in] points finite, no two equal
 * @param[in] fraction above 0, at least 1e-9
 */
NearPoints FindNearPoints(const std::vector<Point>& points, double fraction);
} // namespace insideout
