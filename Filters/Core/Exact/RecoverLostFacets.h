// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/RecoverSegments.h"

namespace insideout
{
/**
 * Recover lost facets by ruin and recreate (Schrimpf et al. 2000): release the facets around a lost
 * one, and recover all of them in another order. If more facets are lost afterwards, restore the
 * mesh. Repeat while work is left. Facets that cross others stay lost.
 * @param[in] points of the mesh, as they were given
 * @param[in] from the end of segments at which Steiner points began; attempts alternate between the
 * ends, the other first
 */
void RecoverLostFacets(ExactState& state, const std::vector<Point>& points, SplitFrom from);
} // namespace insideout
