// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Resolve/SplittableFacets.h"

namespace insideout
{
/**
 * Remove slivers that rounding made: if a facet's corner lies within `radius` of its longest edge,
 * that edge is split there. All other facets along the edge are split at the corner, and the sliver
 * vanishes. No point moves, and facets that closed a volume still do.
 *
 * @param[in] facets candidates may be degenerate, but have three different corners
 * @param[in] candidates facets that may be slivers
 * @param[in] radius in units of the points
 */
Replacement CollapseSlivers(const std::vector<Point>& points, const std::vector<Triangle>& facets,
  const std::vector<Id>& candidates, double radius);
} // namespace insideout
