// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/ExactState.h"

namespace insideout
{
/**
 * Give Steiner points that lie exactly on segments and facets coordinates in doubles. A point on a
 * segment may go anywhere along it; off the exact place every point may go as far as rounding
 * errors are large, and the facets around bend with it. All cells stay positive, so nothing comes
 * to cross. Where the new place would turn cells over, others take their place (MovePoint).
 *
 * Points that cannot be rounded are removed where possible, first in order and then at random, as
 * long as there get fewer.
 * @param[in] maySplitBeside whether further points may come in the end (SplitBeside)
 * @param[in] since as for Tidy
 * @return the ones that are left
 */
std::vector<Id> RoundPoints(ExactState& state, bool maySplitBeside, std::int64_t since);

/** Round each point at the first of its places that will do. @return the ones that are left */
std::vector<Id> RoundInOrder(ExactState& state);

/** The same, of the places for each point only some at random. */
std::vector<Id> RoundAtRandom(ExactState& state);

/** Move Steiner points around some points to other places at random: they may be in the way. */
void Stir(ExactState& state, const std::vector<Id>& points);

/**
 * Put further Steiner points, in doubles, on both sides of those that lie on segments. Where a
 * segment passes between facets that are less than rounding errors apart, no place in doubles may
 * be there for one point, but for two, one on either side.
 */
void SplitBeside(ExactState& state, const std::vector<Id>& points);
} // namespace insideout
