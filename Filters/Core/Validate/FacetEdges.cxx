// SPDX-License-Identifier: GPL-3.0-or-later
#include "Validate/FacetEdges.h"

#include "Common/Buckets.h"
#include "Common/DisjointSets.h"
#include "Common/ParallelLoop.h"

#include <algorithm>
#include <cstdint>
#include <functional>

namespace insideout
{
namespace
{
constexpr double NanosecondsPerFacet = 20; ///< for entering its edges
constexpr double NanosecondsPerPoint = 40; ///< for sorting the edges of which it is the lower one

/** An edge with a given lower point as a number, ordered by its higher point, then by its facet. A
 * facet has an edge twice if it has a point twice. */
std::uint64_t KeyOf(Id high, Id facet, bool runsUpward)
{
  return static_cast<std::uint64_t>(high) << 32 | static_cast<std::uint64_t>(facet) << 1 |
    static_cast<std::uint64_t>(runsUpward);
}

FacetEdge EdgeOf(Id low, std::uint64_t key)
{
  return { low, static_cast<Id>(key >> 32), static_cast<Id>(static_cast<std::uint32_t>(key) >> 1),
    (key & 1) != 0 ? 1 : -1 };
}
} // namespace

FacetEdges SortedFacetEdges(const std::vector<Triangle>& facets)
{
  Id points = 0;
  for (const Triangle& facet : facets)
  {
    points = std::max({ points, facet[0] + 1, facet[1] + 1, facet[2] + 1 });
  }
  // Bucket sort by lower points; buckets are small.
  Buckets<std::uint64_t> byLow = Buckets<std::uint64_t>::Unordered(static_cast<std::size_t>(points),
    facets.size(), NanosecondsPerFacet,
    [&](std::size_t f, const auto& visit)
    {
      for (int k = 0; k < 3; ++k)
      {
        const Id from = facets[f][k];
        const Id to = facets[f][(k + 1) % 3];
        visit(static_cast<std::size_t>(std::min(from, to)),
          KeyOf(std::max(from, to), static_cast<Id>(f), from < to));
      }
    });
  FacetEdges edges(3 * facets.size());
  ParallelLoop(byLow.Size(), NanosecondsPerPoint,
    [&](std::size_t low)
    {
      byLow.Sort(low, std::less<>());
      FacetEdge* edge = edges.data() + (byLow[low].First - byLow[0].First);
      for (const std::uint64_t key : byLow[low])
      {
        *edge++ = EdgeOf(static_cast<Id>(low), key);
      }
    });
  return edges;
}

FacetComponents ComponentsOfFacets(Id numberOfFacets, const FacetEdges& edges)
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
