// SPDX-License-Identifier: GPL-3.0-or-later
#include "Validate/FacetEdges.h"

#include <algorithm>
#include <numeric>
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
  // Union-find in which the root of a component is its lowest facet.
  std::vector<Id> parent(numberOfFacets);
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&parent](Id f)
  {
    while (parent[f] != f)
    {
      f = parent[f] = parent[parent[f]];
    }
    return f;
  };
  ForEachEdge(edges,
    [&](const FacetEdge* first, const FacetEdge* last)
    {
      for (const FacetEdge* edge = first + 1; edge != last; ++edge)
      {
        const Id a = root(first->Facet);
        const Id b = root(edge->Facet);
        parent[std::max(a, b)] = std::min(a, b);
      }
    });

  FacetComponents components;
  components.Component.resize(numberOfFacets);
  for (Id f = 0; f < numberOfFacets; ++f)
  {
    const Id r = root(f);
    components.Component[f] = r == f ? components.Count++ : components.Component[r];
  }
  return components;
}
} // namespace insideout
