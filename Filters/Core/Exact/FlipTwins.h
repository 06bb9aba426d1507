// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/ExactState.h"

namespace insideout
{
/**
 * Where a Steiner point beside its exact place splits a facet, the whole facet may be a face, too:
 * its *twin*. Readers of the mesh cannot tell which of both is the facet: flip that face away where
 * possible.
 */
void FlipTwinsAway(ExactState& state);
} // namespace insideout
