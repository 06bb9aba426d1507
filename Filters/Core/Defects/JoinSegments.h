// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <vector>

namespace insideout
{
/**
 * Join segments to maximal polylines. A polyline continues through each point where exactly two
 * segments end. A closed one repeats its first point at its end. The direction depends on the ids
 * only: from the lower end, and around a loop from its lowest point along the segment given first.
 *
 * @param[in] segments pairs of different points, ids from 0 on
 */
std::vector<std::vector<Id>> JoinSegments(const std::vector<std::array<Id, 2>>& segments);
} // namespace insideout
