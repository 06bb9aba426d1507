// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/ValidFacets.h"

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
/** Lets the caller stop the search; forwards no stage and no progress. */
class AskingMonitor : public Monitor
{
public:
  explicit AskingMonitor(Monitor& caller)
    : Caller(caller)
  {
  }

  bool Continue(const char*, double) override
  {
    return this->Caller.Continue(Phases::FindingCrossings.Stage, Phases::FindingCrossings.At(0));
  }

private:
  Monitor& Caller;
};
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
  AskingMonitor asking(monitor);
  for (const std::array<Id, 2>& pair : FindIntersections(points, proper, asking))
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
