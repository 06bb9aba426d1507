// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/RecoverSegments.h"

namespace insideout
{
/**
 * Recover facets that were lost, by ruin and recreate (Schrimpf et al. 2000): facets around a lost
 * one are taken out, and all of them are recovered in another order. Where more are lost
 * afterwards, the mesh is put back as it was. This goes on as long as there is work to spare.
 * Facets that cross others stay lost.
 * @param[in] points of the mesh, as they were given
 * @param[in] from the end of segments at which Steiner points began; now it is the other in turn
 */
void RecoverLostFacets(ExactState& state, const std::vector<Point>& points, SplitFrom from);
} // namespace insideout
