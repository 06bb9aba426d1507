// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/Types.h"

#include <set>
#include <vector>

namespace insideout
{
/** The facets whose corners are not on one line, ascending. */
std::vector<Id> FacetsWithArea(
  const std::vector<Point>& points, const std::vector<Triangle>& facets);

/**
 * Facets that meet others beyond shared corners and edges, or are duplicated: no mesh has all of
 * these. Others than those asked for may be missing.
 *
 * @param[in] among the facets asked for
 * @throws Error Stopped
 */
std::set<Id> FacetsThatCross(const std::vector<Point>& points, const std::vector<Triangle>& facets,
  const std::vector<Id>& among, Monitor& monitor);

/** The facets that are not among others. @param[in] facets ascending */
std::vector<Id> Without(const std::set<Id>& others, const std::vector<Id>& facets);
} // namespace insideout
