// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/ExactTetrahedralization.h"

#include "Exact/EngineLimits.h"
#include "Exact/RecoveryAttempt.h"
#include "Exact/ValidFacets.h"

#include <utility>

namespace insideout
{
namespace
{
/** One attempt, and more without the facets that it has to give up, of which there are fewer each
 * time. */
ExactTetrahedralization AttemptUntilPointsHavePlaces(const std::vector<Point>& points,
  const std::vector<Triangle>& facets, SegmentRecovery::From from, std::int64_t workPerElement,
  Monitor& monitor)
{
  std::vector<Id> names = FacetsWithArea(points, facets);
  for (int attempts = 1;; ++attempts)
  {
    std::vector<Triangle> chosen;
    for (const Id name : names)
    {
      chosen.push_back(facets[name]);
    }
    RecoveryAttempt attempt(points, chosen, workPerElement, monitor);
    if (attempt.Run(from))
    {
      ExactTetrahedralization result = { attempt.Result(), attempt.WorkSpent() };
      for (Id& facet : result.Tetrahedra.FacetOfFaces)
      {
        facet = names[facet];
      }
      return result;
    }
    std::vector<Id> kept;
    for (Id f = 0; f < static_cast<Id>(names.size()); ++f)
    {
      if (attempt.FacetsGivenUp().count(f) == 0)
      {
        kept.push_back(names[f]);
      }
    }
    // Without facets there are no Steiner points, so this ends.
    const bool isHopeless = attempts == EngineLimits::Attempts || kept.size() == names.size();
    names = isHopeless ? std::vector<Id>() : std::move(kept);
  }
}

/** Facets that no face carries, ascending. */
std::vector<Id> FacetsWithoutFaces(std::size_t numberOfFacets, const std::vector<Id>& facetOfFaces)
{
  std::vector<bool> isThere(numberOfFacets, false);
  for (const Id facet : facetOfFaces)
  {
    isThere[facet] = true;
  }
  std::vector<Id> missing;
  for (std::size_t f = 0; f < numberOfFacets; ++f)
  {
    if (!isThere[f])
    {
      missing.push_back(static_cast<Id>(f));
    }
  }
  return missing;
}
} // namespace

ExactTetrahedralization TetrahedralizeExactly(const std::vector<Point>& points,
  const std::vector<Triangle>& facets, Monitor& monitor, std::int64_t workPerElement)
{
  ForwardMonitor forward(monitor);
  ExactTetrahedralization best;
  std::vector<Id> missing;
  for (const auto from : { SegmentRecovery::From::LowerEnd, SegmentRecovery::From::HigherEnd })
  {
    const bool isFirst = best.Tetrahedra.Cells.empty();
    if (!isFirst && Without(FacetsThatCross(points, facets, forward), missing).empty())
    {
      break;
    }
    ExactTetrahedralization result =
      AttemptUntilPointsHavePlaces(points, facets, from, workPerElement, forward);
    std::vector<Id> now = FacetsWithoutFaces(facets.size(), result.Tetrahedra.FacetOfFaces);
    if (isFirst || now.size() < missing.size())
    {
      best = std::move(result);
      missing = std::move(now);
    }
    if (missing.empty())
    {
      break;
    }
  }
  return best;
}
} // namespace insideout
