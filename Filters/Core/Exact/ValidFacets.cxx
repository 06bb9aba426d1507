// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/ValidFacets.h"

#include "Common/BoxTree.h"
#include "Common/ParallelLoop.h"
#include "Common/PartMonitor.h"
#include "Common/PointPredicates.h"
#include "Common/SortedTriangle.h"
#include "Exact/Phases.h"
#include "Resolve/FindIntersections.h"

#include <algorithm>
#include <iterator>

namespace insideout
{
namespace
{
/** Per facet, whether its box meets that of one of some facets. */
std::vector<char> NearFacets(const std::vector<Point>& points, const std::vector<Triangle>& facets,
  const std::vector<Id>& some)
{
  constexpr double NanosecondsPerFacet = 100;
  std::vector<Box> boxes;
  for (const Id facet : some)
  {
    boxes.push_back(BoundingBox(points, facets[facet]));
  }
  const BoxTree tree(boxes);
  std::vector<char> isNear(facets.size(), 0);
  ParallelLoop(facets.size(), NanosecondsPerFacet,
    [&](std::size_t facet)
    { tree.Visit(BoundingBox(points, facets[facet]), [&](Id) { isNear[facet] = 1; }); });
  return isNear;
}
} // namespace

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

std::set<Id> FacetsThatCross(const std::vector<Point>& points, const std::vector<Triangle>& facets,
  const std::vector<Id>& among, Monitor& monitor)
{
  std::set<Id> crossing;
  if (among.empty())
  {
    return crossing;
  }
  const std::vector<char> isNear = NearFacets(points, facets, among);
  std::vector<Id> names;
  std::vector<Triangle> proper;
  std::set<Triangle> known;
  for (Id facet = 0; facet < static_cast<Id>(facets.size()); ++facet)
  {
    if (isNear[facet] == 0 || IsDegenerate(points, facets[facet]))
    {
      continue;
    }
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
