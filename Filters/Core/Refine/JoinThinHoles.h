// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Refine/RefinableSurface.h"
#include "Refine/RefineTetrahedra.h"

#include <vector>

namespace insideout
{
/**
 * Join facets that close holes to others between the same regions, if they are within a distance of
 * these everywhere: mostly slits between parts that do not quite meet. They get the label of the
 * facet nearest to their center.
 *
 * @param[in] regions one per cell; empty: all are one
 * @param[in] parameters Labels and LabelOfHoles
 * @param[in,out] facets of the mesh (FacetsOf)
 */
void JoinThinHoles(const std::vector<Id>& regions, const RefinementParameters& parameters,
  double distance, std::vector<FacetOfInput>& facets);
} // namespace insideout
