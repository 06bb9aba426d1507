// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "WindingNumber/ChainFacets.h"

namespace insideout
{
/**
 * A box with a reference place at which a closed chain's winding number is known. At another place
 * in the box it differs by the count of the facets between the two.
 */
struct KnownBox
{
  Box Bounds;
  Point Reference;
  double Value;                 ///< NaN if no site is wanted
  const SidedFacet* FirstFacet; ///< all that may meet the box, with the reference's side of each
  const SidedFacet* LastFacet;
};

/**
 * The winding number at a site in the box. Where the line from it to the reference meets an edge or
 * a corner, a detour is made.
 *
 * @throws Error Inconsistent where no detour would do
 */
double WindingNumberIn(const KnownBox& box, const ChainFacets& facets, const PreparedSite& site);
} // namespace insideout
