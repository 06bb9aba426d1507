// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/ExactState.h"

namespace insideout
{
/** Stop trying after this many rounds of shaking that remove no point. */
constexpr int ShakesWithoutGain = 12;

/**
 * Replace Steiner points from `first` on that lie on facets by points beside these, if they are
 * needed; then remove those that are not needed, which are more in the volume.
 * @param[in] since points around which nothing has changed since (FlippableMesh::NumberOfChanges)
 *            stay as they are
 */
void Tidy(ExactState& state, Id first, std::int64_t since = -1);

/**
 * Flip at random around points, and then try again to do without them, or to have them in the
 * volume: the cells that bar the way are others each time.
 */
void Shake(ExactState& state, const std::vector<Id>& points);

/** Flip at random in the cells around a vertex. */
void FlipAround(ExactState& state, Id vertex);
} // namespace insideout
