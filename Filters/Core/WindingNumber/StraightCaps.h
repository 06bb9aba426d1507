// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "WindingNumber/WalkedWindingNumber.h"

namespace insideout
{
/**
 * An input triangle that stands in for its pieces.
 *
 * Resolving cut the triangle, and the pieces' corners are rounded, so they lie off it by a rounding
 * error. Slivers fill the gap between its straight sides and the pieces' outline: triangle, slivers
 * and the pieces turned over make a closed chain that is flat but for rounding. Off that chain's
 * hull the pieces have the winding number of the triangle and the slivers.
 */
struct StraightCap
{
  CountedTriangle Whole = { { { None, None, None } }, 0 };
  double Height = 0; ///< of pieces and slivers above and below the triangle's plane, at most
  std::size_t FirstPiece = 0;
  std::size_t LastPiece = 0;
  std::size_t FirstSliver = 0;
  std::size_t LastSliver = 0;
};

/** Pieces and slivers are at most this far from the triangle, whose coordinates are below 1. */
constexpr double ReachOfStraightCap = 0x1p-46;

/** A chain of triangles: those that caps replace, and the rest. */
struct StraightCaps
{
  std::vector<StraightCap> Caps;
  std::vector<CountedTriangle> Pieces;  ///< of cap after cap
  std::vector<CountedTriangle> Slivers; ///< likewise; none is degenerate
  std::vector<char> HasCap; ///< per facet of the complex: whether it is among the pieces
  std::vector<CountedTriangle> Rest;
};

/**
 * Find the input triangles whose outline is mostly open and which can stand in for their pieces.
 *
 * @param[in] surface whose facets have their sources; without these there are no caps
 * @param[in] points of the chain, below 1 in each coordinate
 * @param[in] chain the complex as counted triangles, each of which belongs to a facet
 * @param[in] boundary of the complex's facets
 */
StraightCaps FindStraightCaps(const FacetComplex& surface, const std::vector<Point>& points,
  const ChainOfFacets& chain, const std::vector<CountedEdge>& boundary);
} // namespace insideout
