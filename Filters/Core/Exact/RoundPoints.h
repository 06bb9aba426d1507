// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/ExactState.h"

namespace insideout
{
/**
 * Give Steiner points that lie exactly on segments and facets coordinates in doubles. A point on a
 * segment may move along it; any point may move off its exact position by the size of rounding
 * errors, and the facets around bend with it. All cells stay positive, so nothing comes to cross.
 * If the new position would invert cells, they are reconnected (MovePoint).
 *
 * Points that cannot be rounded are removed where possible, first in order and then at random, as
 * long as there get fewer.
 * @param[in] maySplitBeside whether further points may come in the end (SplitBeside)
 * @param[in] since as for Tidy
 * @return the ones that are left
 */
std::vector<Id> RoundPoints(ExactState& state, bool maySplitBeside, std::int64_t since);

/** Round each point to the first possible one of its candidates. @return the remaining points */
std::vector<Id> RoundInOrder(ExactState& state);

/** The same, with a random selection of the candidates of each point. */
std::vector<Id> RoundAtRandom(ExactState& state);

/** Move Steiner points around some points randomly: they may be obstacles. */
void Stir(ExactState& state, const std::vector<Id>& points);

/**
 * Put further Steiner points, in doubles, on both sides of those that lie on segments. If a segment
 * passes between facets closer than rounding errors, a single point may not fit there in doubles,
 * but two may, one on either side.
 */
void SplitBeside(ExactState& state, const std::vector<Id>& points);
} // namespace insideout
