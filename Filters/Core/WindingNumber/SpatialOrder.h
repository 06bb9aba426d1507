// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "WindingNumber/Sites.h"

namespace insideout
{
/**
 * The indices of `positions` in the order of a Z-shaped curve through their bounding box (Morton
 * 1966), so that neighbors in space are mostly neighbors in the order. Equal places keep their
 * order.
 *
 * @param[in] positions finite
 */
std::vector<Id> SpatialOrder(const std::vector<Point>& positions);

/** The same with positions that need not be finite; those count as 0. */
std::vector<Id> SpatialOrderOfAny(std::vector<Point> positions);

/** The same for sites, by their rounded positions. */
std::vector<Id> SpatialOrder(const Sites& sites);
} // namespace insideout
