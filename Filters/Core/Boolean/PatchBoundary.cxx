// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/PatchBoundary.h"

#include "Common/Error.h"

namespace insideout
{
namespace
{
/** Per facet, +1 if it is on the boundary and its normal points outward, -1 if inward, else 0. */
std::vector<signed char> SidesOfFacets(const SurfacePatches& patches, const PatchPlaces& places,
  const std::vector<HoldsBeside>& holds, const std::vector<int>& counts)
{
  std::vector<signed char> sides(counts.size(), 0);
  for (std::size_t f = 0; f < counts.size(); ++f)
  {
    const Id patch = patches.Patch[f];
    if (holds[patch].Front != holds[patch].Back)
    {
      const bool runAlike = counts[f] == counts[places.FacetOf(patch)];
      sides[f] = holds[patch].Back == runAlike ? 1 : -1;
    }
  }
  return sides;
}

/** @throws Error Inconsistent */
void CheckBalance(const FacetEdges& edges, const std::vector<signed char>& sides)
{
  ForEachEdge(edges,
    [&](const FacetEdge* first, const FacetEdge* last)
    {
      int sum = 0;
      for (const FacetEdge* edge = first; edge != last; ++edge)
      {
        sum += edge->Direction * sides[edge->Facet];
      }
      if (sum != 0)
      {
        throw Error(ErrorCode::Inconsistent,
          "the boundary is open at the edge of points " + std::to_string(first->Low) + " and " +
            std::to_string(first->High));
      }
    });
}
} // namespace

std::vector<BoundaryTriangle> PatchBoundary(const FacetComplex& surface, const FacetEdges& edges,
  const SurfacePatches& patches, const PatchPlaces& places, const std::vector<HoldsBeside>& holds,
  const std::vector<int>& counts)
{
  const std::vector<signed char> sides = SidesOfFacets(patches, places, holds, counts);
  CheckBalance(edges, sides);
  std::vector<BoundaryTriangle> triangles;
  triangles.reserve(surface.Facets.size());
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    if (sides[f] != 0)
    {
      const auto [a, b, c] = surface.Facets[f];
      triangles.push_back({ sides[f] > 0 ? Triangle{ { a, b, c } } : Triangle{ { a, c, b } },
        SourceOfFacet(surface, f, sides[f]) });
    }
  }
  return triangles;
}
} // namespace insideout
