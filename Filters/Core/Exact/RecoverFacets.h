// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/ExactState.h"

namespace insideout
{
/** Facets whose edges are in the mesh become unions of marked faces. */

/** Mark every facet that is one face between segments none of which is split. @return the others */
std::vector<Id> MarkWholeFacets(ExactState& state, const std::vector<Id>& facets);

/** The facets missing in the mesh, after a search for those that are faces by chance. */
std::vector<Id> FindLostFacets(ExactState& state);

/** Recover facets by flips alone. @return the ones that are still missing */
std::vector<Id> RecoverFacetsByFlips(ExactState& state, const std::vector<Id>& missing);

/**
 * Recover facets by inserting a Steiner point wherever an edge crosses one. New edges end on the
 * facet and do not cross it, so each edge is split once.
 * @return facets with a missing edge
 */
std::vector<Id> RecoverFacetsBySplits(ExactState& state, const std::vector<Id>& missing);
} // namespace insideout
