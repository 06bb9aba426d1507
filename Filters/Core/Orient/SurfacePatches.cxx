// SPDX-License-Identifier: GPL-3.0-or-later
#include "Orient/SurfacePatches.h"

#include "Common/DisjointSets.h"
#include "Common/FacetComplex.h"

namespace insideout
{
SurfacePatches FindPatches(const FacetComplex& surface, const FacetEdges& edges)
{
  DisjointSets sets(surface.Facets.size());
  const auto opposed = [&](const FacetEdge& edge)
  { return surface.Opposed.empty() ? 0 : surface.Opposed[edge.Facet]; };
  const auto run = [&](const FacetEdge& a, const FacetEdge& b)
  {
    const int sum =
      a.Direction * surface.Multiplicity[a.Facet] + b.Direction * surface.Multiplicity[b.Facet];
    return sum == 0 && opposed(a) == opposed(b) &&
      (opposed(a) == 0 || surface.Multiplicity[a.Facet] != 0 || a.Direction != b.Direction);
  };
  ForEachEdge(edges,
    [&](const FacetEdge* first, const FacetEdge* last)
    {
      if (last - first == 2 && run(first[0], first[1]))
      {
        sets.Join(first[0].Facet, first[1].Facet);
      }
    });
  SurfacePatches patches;
  patches.Patch.resize(surface.Facets.size());
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    const Id lowest = sets.Find(f);
    patches.Patch[f] = lowest == f ? patches.Count++ : patches.Patch[lowest];
  }
  return patches;
}
} // namespace insideout
