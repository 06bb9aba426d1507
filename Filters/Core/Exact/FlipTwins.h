// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/ExactState.h"

namespace insideout
{
/**
 * A facet that a rounded Steiner point splits may also be a single face: its *twin*. Readers of the
 * mesh cannot distinguish the two, so flip the twin away where possible.
 */
void FlipTwinsAway(ExactState& state);
} // namespace insideout
