// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "Validate/FacetEdges.h"

namespace insideout
{
struct TwoSidedComponents
{
  Id Solids = 0; ///< now kept once, outward
  Id Sheets = 0; ///< left at multiplicity 0
};

/**
 * Find the components in which every facet has multiplicity 0, because it was given in both
 * orientations. Their patches consist of facets joined through edges of exactly two. If a patch
 * closes a volume when each facet is kept once, it gets multiplicities of +1 and -1 that turn it
 * outward: modelers mean the solid. The others are sheets, and stay at 0.
 *
 * @param[in,out] surface Multiplicity changes
 * @param[in] edges,components of surface.Facets
 */
TwoSidedComponents KeepTwoSidedSolids(
  FacetComplex& surface, const FacetEdges& edges, const FacetComponents& components);
} // namespace insideout
