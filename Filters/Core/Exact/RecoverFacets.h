// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/ExactState.h"

namespace insideout
{
/** Facets, whose edges the mesh has, become unions of faces of the mesh, which are marked. */

/** Mark every facet that is one face between segments none of which is split. @return the others */
std::vector<Id> MarkWholeFacets(ExactState& state, const std::vector<Id>& facets);

/** The facets missing in the mesh, after a search for those that are faces by chance. */
std::vector<Id> FindLostFacets(ExactState& state);

/** Recover facets by flips alone. @return the ones that are still missing */
std::vector<Id> RecoverFacetsByFlips(ExactState& state, const std::vector<Id>& missing);

/**
 * Recover facets by putting a Steiner point on each where an edge crosses it. Edges get no end
 * beyond the facet by that, so it is done once per edge.
 * @return facets of which an edge is missing
 */
std::vector<Id> RecoverFacetsBySplits(ExactState& state, const std::vector<Id>& missing);
} // namespace insideout
