// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Resolve/PlanarSubdivision.h"
#include "Resolve/SplittableFacets.h"

namespace insideout
{
/** How the pieces of a facet split one of its edges: points from Edge[0] to Edge[1]. */
struct EdgeChain
{
  Edge Along;
  std::vector<Id> Points;
};

/**
 * The chains of all edges of all facets of a subdivision.
 *
 * @param[in] ids of the subdivision's points among the surface's
 */
std::vector<EdgeChain> ChainsOf(const PlanarSubdivision& subdivision, const std::vector<Id>& ids);

/**
 * Split facets so that all facets along an edge have the same points on it: those of all chains.
 *
 * @param[in] facets including the pieces, and the facets that still have whole edges
 */
Replacement SplitAlike(const std::vector<Point>& points, const std::vector<Triangle>& facets,
  const std::vector<EdgeChain>& chains);
} // namespace insideout
