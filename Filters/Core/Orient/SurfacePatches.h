// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Validate/FacetEdges.h"

namespace insideout
{
struct FacetComplex;

/** Facets in patches, numbered from 0 by their lowest facet. */
struct SurfacePatches
{
  std::vector<Id> Patch; ///< one per facet
  Id Count = 0;
};

/**
 * Patches: the largest sets of facets that are joined through edges where exactly two facets meet,
 * which run along the edge opposite ways and count as often, and of whose copies as many cancel
 * (FacetComplex::Opposed). On a resolved surface nothing else
 * comes near such an edge, so that the winding number just beside a patch changes by no jump along
 * it, on either side (Zhou, Grinspun, Zorin and Jacobson 2016, section 4).
 *
 * @param[in] edges those of surface.Facets
 */
SurfacePatches FindPatches(const FacetComplex& surface, const std::vector<FacetEdge>& edges);
} // namespace insideout
