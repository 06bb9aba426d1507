// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/ExactState.h"

namespace insideout
{
/**
 * Give Steiner points that lie exactly on segments and facets coordinates in doubles. A point on a
 * segment may move along it; any point may move off its exact position by the size of rounding
 * errors, and the facets around it bend. All cells stay positive, so no crossing arises. If the new
 * position would invert cells, they are reconnected (MovePoint).
 *
 * Points that cannot be rounded are removed where possible, first in order, then after random flips
 * around them (Shake), for as long as their number drops.
 * @param[in] since as for Tidy
 * @return the ones that are left
 */
std::vector<Id> RoundPoints(ExactState& state, std::int64_t since);

/** Round each point to the first possible one of its candidates. @return the remaining points */
std::vector<Id> RoundInOrder(ExactState& state);
} // namespace insideout
