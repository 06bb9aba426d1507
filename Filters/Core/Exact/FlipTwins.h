// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/ExactState.h"

namespace insideout
{
/**
 * If a Steiner point near its exact position splits a facet, the whole facet may be a face, too:
 * its *twin*. Readers of the mesh cannot distinguish the two: flip the twin away where possible.
 */
void FlipTwinsAway(ExactState& state);
} // namespace insideout
