// SPDX-License-Identifier: GPL-3.0-or-later
#include "Validate/FacetEdges.h"

#include "Common/DisjointSets.h"

#include <algorithm>
#include <tuple>

namespace insideout
{
std::vector<FacetEdge> SortedFacetEdges(const std::vector<Triangle>& facets)
{
  std::vector<FacetEdge> edges;
  edges.reserve(3 * facets.size());
  for (std::size_t f = 0; f < facets.size(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Id from = facets[f][k];
      const Id to = facets[f][(k + 1) % 3];
      edges.push_back(
        { std::min(from, to), std::max(from, to), static_cast<Id>(f), from < to ? 1 : -1 });
    }
  }
  std::sort(edges.begin(), edges.end(),
    [](const FacetEdge& a, const FacetEdge& b)
    { return std::tie(a.Low, a.High, a.Facet) < std::tie(b.Low, b.High, b.Facet); });
  return edges;
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
