// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Resolve/SplittableFacets.h"

namespace insideout
{
/**
 * Takes slivers away that rounding left: where a facet's corner lies within `radius` of its longest
 * edge, the corner becomes a point of that edge. Every other facet along the edge is split there,
 * and the sliver has no room left. No point moves, and where facets closed a volume they still do.
 *
 * @param[in] facets may be degenerate if they are candidates, but have three different corners
 * @param[in] candidates facets that may be slivers
 * @param[in] radius in units of the points
 */
Replacement CollapseSlivers(const std::vector<Point>& points, const std::vector<Triangle>& facets,
  const std::vector<Id>& candidates, double radius);
} // namespace insideout
