// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "Common/Monitor.h"

namespace insideout
{
/** A part of a surface, with caps over the edges that it was cut off along. */
struct CountedPiece
{
  FacetComplex Surface; ///< points, facets and what they count: the whole's facets, then caps
  std::vector<Id> WholeFacets; ///< which of the whole those are, ascending; caps are none
};

/**
 * Cut a surface into pieces whose winding numbers add up to its own, also on the surface, so that
 * they can be held one after the other.
 *
 * Space is halved again and again, so that each piece lies in a box of its own but for facets on
 * the border. Where that cuts the surface in two, one side loses what the other gains: caps (as in
 * HoleCaps.h) over the cut. So each piece is closed if the surface is, and its winding number is a
 * whole number.
 *
 * @param[in] facetsPerPiece at least 1: no piece has more facets beside its caps, and there are no
 * more pieces than that takes
 * @return at least one piece; every facet is in one, also one that counts 0
 * @throws Error (Stopped)
 */
std::vector<CountedPiece> CutIntoPieces(
  const FacetComplex& surface, Id facetsPerPiece, Monitor& monitor);
} // namespace insideout
