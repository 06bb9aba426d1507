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
 * Patches: the largest sets of facets joined through edges of exactly two facets that run along the
 * edge in opposite directions. The two have the same count, and the same number of canceling copies
 * (FacetComplex::Opposed). On a resolved surface no other facet touches such an edge. So the
 * winding number just beside a patch is constant on either side (Zhou, Grinspun, Zorin and Jacobson
 * 2016, section 4).
 *
 * @param[in] edges those of surface.Facets
 */
SurfacePatches FindPatches(const FacetComplex& surface, const FacetEdges& edges);
} // namespace insideout
