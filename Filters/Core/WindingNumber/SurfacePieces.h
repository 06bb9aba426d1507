// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "Common/Monitor.h"
#include "WindingNumber/CountedBoundary.h"

namespace insideout
{
/** A part of a surface. */
struct CountedPiece
{
  FacetComplex Surface;              ///< points, facets and counts
  std::vector<Id> WholeFacets;       ///< the first facets' indices in the whole, ascending
  std::vector<CountedEdge> Boundary; ///< of the facets, once ClosePieces has closed it or made it
};

/**
 * Cut a surface into pieces that can be held one after the other, each facet in one of them.
 *
 * Space is bisected recursively, so that each piece lies in its own box but for facets on the
 * border.
 *
 * @param[in] facetsPerPiece at least 1: no piece has more facets, and there are no more pieces than
 * this requires
 * @return at least one piece; every facet is in one, also one that counts 0
 * @throws Error (Stopped)
 */
std::vector<CountedPiece> CutIntoPieces(
  const FacetComplex& surface, Id facetsPerPiece, Monitor& monitor);
} // namespace insideout
