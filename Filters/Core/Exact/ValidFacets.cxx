// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/ValidFacets.h"

#include "Common/PartMonitor.h"
#include "Common/PointPredicates.h"
#include "Common/SortedTriangle.h"
#include "Exact/Phases.h"
#include "Resolve/FindIntersections.h"

#include <algorithm>
#include <iterator>

namespace insideout
{
std::vector<Id> FacetsWithArea(
  const std::vector<Point>& points, const std::vector<Triangle>& facets)
{
  std::vector<Id> proper;
  for (std::size_t f = 0; f < facets.size(); ++f)
  {
    if (!IsDegenerate(points, facets[f]))
    {
      proper.push_back(static_cast<Id>(f));
    }
  }
  return proper;
}

std::set<Id> FacetsThatCross(
  const std::vector<Point>& points, const std::vector<Triangle>& facets, Monitor& monitor)
{
  std::set<Id> crossing;
  std::vector<Id> names;
  std::vector<Triangle> proper;
  std::set<Triangle> known;
  for (const Id facet : FacetsWithArea(points, facets))
  {
    if (known.insert(SortedTriangle(facets[facet]).Points).second)
    {
      names.push_back(facet);
      proper.push_back(facets[facet]);
    }
    else
    {
      crossing.insert(facet);
    }
  }
  QuietMonitor quiet(monitor, Phases::FindingCrossings);
  for (const std::array<Id, 2>& pair : FindIntersections(points, proper, quiet))
  {
    crossing.insert({ names[pair[0]], names[pair[1]] });
  }
  return crossing;
}

std::vector<Id> Without(const std::set<Id>& others, const std::vector<Id>& facets)
{
  std::vector<Id> rest;
  std::set_difference(
    facets.begin(), facets.end(), others.begin(), others.end(), std::back_inserter(rest));
  return rest;
}
} // namespace insideout
