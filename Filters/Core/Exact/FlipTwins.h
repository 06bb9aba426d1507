// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/ConstrainedMesh.h"

namespace insideout
{
/**
 * Where a Steiner point beside its exact place splits a facet, the whole facet may be a face, too:
 * its *twin*. Which of both is the facet, each reader of the mesh would have to guess: flip that
 * face away, where that is possible.
 */
void FlipTwinsAway(ConstrainedMesh& constrained);
} // namespace insideout
