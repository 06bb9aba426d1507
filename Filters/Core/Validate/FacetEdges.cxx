// SPDX-License-Identifier: GPL-3.0-or-later
#include "Validate/FacetEdges.h"

#include "Common/Buckets.h"
#include "Common/DisjointSets.h"
#include "Common/ParallelLoop.h"

#include <algorithm>
#include <tuple>

namespace insideout
{
namespace
{
constexpr double NanosecondsPerFacet = 20; ///< for entering its edges
constexpr double NanosecondsPerPoint = 40; ///< for sorting the edges of which it is the lower one
} // namespace

std::vector<FacetEdge> SortedFacetEdges(const std::vector<Triangle>& facets)
{
  Id points = 0;
  for (const Triangle& facet : facets)
  {
    points = std::max({ points, facet[0] + 1, facet[1] + 1, facet[2] + 1 });
  }
  // Bucket sort by lower points; buckets are small.
  Buckets<FacetEdge> byLow = Buckets<FacetEdge>::Unordered(static_cast<std::size_t>(points),
    facets.size(), NanosecondsPerFacet,
    [&](std::size_t f, const auto& visit)
    {
      for (int k = 0; k < 3; ++k)
      {
        const Id from = facets[f][k];
        const Id to = facets[f][(k + 1) % 3];
        const Id low = std::min(from, to);
        visit(static_cast<std::size_t>(low),
          FacetEdge{ low, std::max(from, to), static_cast<Id>(f), from < to ? 1 : -1 });
      }
    });
  ParallelLoop(byLow.Size(), NanosecondsPerPoint,
    [&](std::size_t low)
    {
      byLow.Sort(low,
        [](const FacetEdge& a, const FacetEdge& b)
        {
          // A facet has an edge twice if it has a point twice.
          return std::tie(a.High, a.Facet, a.Direction) < std::tie(b.High, b.Facet, b.Direction);
        });
    });
  return std::move(byLow).TakeAll();
}

FacetComponents ComponentsOfFacets(Id numberOfFacets, const std::vector<FacetEdge>& edges)
{
  DisjointSets sets(numberOfFacets);
  ForEachEdge(edges,
    [&](const FacetEdge* first, const FacetEdge* last)
    {
      for (const FacetEdge* edge = first + 1; edge != last; ++edge)
      {
        sets.Join(first->Facet, edge->Facet);
      }
    });

  FacetComponents components;
  components.Component.resize(numberOfFacets);
  for (Id f = 0; f < numberOfFacets; ++f)
  {
    const Id r = sets.Find(f);
    components.Component[f] = r == f ? components.Count++ : components.Component[r];
  }
  return components;
}
} // namespace insideout
