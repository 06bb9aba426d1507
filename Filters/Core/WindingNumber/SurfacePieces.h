// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "Common/Monitor.h"

namespace insideout
{
/** A part of a surface, with caps over the edges along which it was cut off. */
struct CountedPiece
{
  FacetComplex Surface;        ///< points, facets and counts: facets of the whole, then caps
  std::vector<Id> WholeFacets; ///< indices of these facets in the whole, ascending; caps have none
};

/**
 * Cut a surface into pieces whose winding numbers add up to its own, also on the surface, so that
 * they can be held one after the other.
 *
 * Space is bisected recursively, so that each piece lies in its own box but for facets on the
 * border. Where this cuts the surface in two, caps (as in HoleCaps.h) over the cut are added to one
 * side and subtracted from the other. So each piece of a closed surface is closed, and its winding
 * number is a whole number.
 *
 * @param[in] facetsPerPiece at least 1: no piece has more facets, caps aside, and there are no more
 * pieces than this requires
 * @return at least one piece; every facet is in one, also one that counts 0
 * @throws Error (Stopped)
 */
std::vector<CountedPiece> CutIntoPieces(
  const FacetComplex& surface, Id facetsPerPiece, Monitor& monitor);
} // namespace insideout
