// SPDX-License-Identifier: GPL-3.0-or-later
#include "Orient/SurfacePatches.h"

#include "Common/DisjointSets.h"
#include "Common/FacetComplex.h"

namespace insideout
{
SurfacePatches FindPatches(const FacetComplex& surface, const std::vector<FacetEdge>& edges)
{
  DisjointSets sets(surface.Facets.size());
  const auto count = [&](const FacetEdge& edge)
  { return edge.Direction * surface.Multiplicity[edge.Facet]; };
  ForEachEdge(edges,
    [&](const FacetEdge* first, const FacetEdge* last)
    {
      if (last - first == 2 && count(first[0]) + count(first[1]) == 0)
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
