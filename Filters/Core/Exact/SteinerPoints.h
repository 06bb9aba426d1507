// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/ExactState.h"

namespace insideout
{
/** Stop trying after this many rounds of shaking that remove no point. */
constexpr int ShakesWithoutGain = 12;

/**
 * Move Steiner points from `first` on from facets into the volume, or remove them if they are not
 * needed there. Then remove points one by one; those in the volume go more easily.
 * @param[in] since points with no change around them after this one
 * (FlippableMesh::NumberOfChanges) stay as they are
 */
void Tidy(ExactState& state, Id first, std::int64_t since = -1);

/**
 * Flip at random around points, then try again to remove them or to move them into the volume.
 * Other cells bar the way each time.
 */
void Shake(ExactState& state, const std::vector<Id>& points);

/** Flip at random around a vertex. */
void FlipAround(ExactState& state, Id vertex);
} // namespace insideout
