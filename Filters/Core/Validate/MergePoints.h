// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <vector>

namespace insideout
{
/**
 * For each point the point that it is merged with, or itself: the lowest point with equal
 * coordinates. With a tolerance above 0 each of these then joins the lowest point within it that
 * has not joined another.
 *
 * @param[in] points if not finite, never near to others
 */
std::vector<Id> MergePoints(const std::vector<Point>& points, double tolerance);
} // namespace insideout
