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

/** Facets that meet others beyond shared corners and edges, or are duplicated: no mesh has all of
 * these. @throws Error Stopped */
std::set<Id> FacetsThatCross(
  const std::vector<Point>& points, const std::vector<Triangle>& facets, Monitor& monitor);

/** The facets that are not among others. @param[in] facets ascending */
std::vector<Id> Without(const std::set<Id>& others, const std::vector<Id>& facets);
} // namespace insideout
