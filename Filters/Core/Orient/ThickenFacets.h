// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "Common/Monitor.h"

namespace insideout
{
struct ThickenParameters
{
  double Width = 0; ///< in units of the surface; 0: nothing is thickened
  bool All = false; ///< every facet, and not only those that enclose nothing
};

/**
 * Give facets a thickness: a closed slab around each set of facets joined through edges of exactly
 * two. It reaches half the width to either side, with rims along the other edges. Slabs may cross
 * each other, themselves and the rest: resolving and winding numbers make one solid of all. Facets
 * that enclose nothing count 0 from then on, but stay, within the slab. Where facets bend, corners
 * of the slab are as far from them as keeps the width, at most twice as far. (The thesis,
 * section 8.7, names thin sheets as what it does not treat.)
 *
 * Facets of the slab have as source that of the facet that they belong to; points take the data of
 * the point that they belong to.
 *
 * @param[in,out] surface validated, not resolved
 * @param[in] isSheet one per facet: those that enclose nothing
 * @return how many facets were thickened
 * @throws Error InvalidParameter where the width is negative, not finite, or too small for the
 *   surface; TooLarge; Stopped
 */
Id ThickenFacets(FacetComplex& surface, const std::vector<char>& isSheet,
  const ThickenParameters& parameters, Monitor& monitor);
} // namespace insideout
