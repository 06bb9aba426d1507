// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Edge.h"
#include "Common/Monitor.h"
#include "Common/ProgressRange.h"
#include "Resolve/ConstructedPoint.h"

namespace insideout
{
/** Facets that all pass near one point, and cross each other there. */
struct Tangle
{
  Point Center;
  std::vector<Id> Facets;  ///< ascending
  std::vector<Edge> Edges; ///< edges of these facets that pass near the center, ascending
  double Distance;         ///< at most, from the center to a facet or edge, in units of the points
  std::size_t Crossings;   ///< points where three of the facets meet, counted in doubles
};

/**
 * Find tangles, which are not worth their exact cuts: if n facets cross each other, up to n^3 / 6
 * points lie on three of them, and each makes six pieces. Facets meant to pass through one point,
 * which rounding has scattered, grow into millions of pieces.
 *
 * A tangle has more than 65,536 such points. The median of these, its center, is at most 1/64 of
 * its longest edge from each facet, and 1/32 of its height from the facet's plane. An edge is near
 * the center within 1/64 of its length.
 *
 * @param[in] pairs all pairs of facets that cross, sorted
 * @return tangles without common facets
 * @throws Error (Stopped)
 */
std::vector<Tangle> FindTangles(const FacetList& surface,
  const std::vector<std::array<Id, 2>>& pairs, Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
