// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "Common/Monitor.h"

namespace insideout
{
struct ThickenParameters
{
  double Width = 0; ///< in the surface's units; 0: no thickening
  bool All = false; ///< every facet, not only sheets
};

/**
 * Give facets a thickness: a closed slab around each set of facets joined through edges of exactly
 * two facets. It reaches half the width to either side, with rims along the other edges. Slabs may
 * cross each other, themselves and the rest: resolving and winding numbers make one solid of all.
 * Facets that enclose nothing then count 0, but stay within the slab. Where facets bend, the slab's
 * corners are moved out to keep the width, at most to twice the distance. (The thesis, section 8.7,
 * leaves thin sheets untreated.)
 *
 * Facets of the slab inherit the source of their facet, points the data of their point.
 *
 * @param[in,out] surface validated, not resolved
 * @param[in] isSheet one per facet: whether it belongs to a shell that encloses nothing
 * @return the number of thickened facets
 * @throws Error InvalidParameter if the width is negative, not finite, or too small for the
 * surface; TooLarge; Stopped
 */
Id ThickenFacets(FacetComplex& surface, const std::vector<char>& isSheet,
  const ThickenParameters& parameters, Monitor& monitor);
} // namespace insideout
