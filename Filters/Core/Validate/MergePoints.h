// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <vector>

namespace insideout
{
/**
 * For each point the one that it becomes, or itself: of points with equal coordinates the lowest.
 * With a tolerance above 0 each of these joins the lowest point at most that far away that has not
 * joined another one.
 *
 * @param[in] points those that are not finite are never near to others
 */
std::vector<Id> MergePoints(const std::vector<Point>& points, double tolerance);
} // namespace insideout
