// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/PatchBoundary.h"

#include "Common/Error.h"

#include <atomic>

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

/** @throws Error Inconsistent, which names the first edge that is open */
void CheckBalance(const FacetEdges& edges, const std::vector<signed char>& sides)
{
  const FacetEdge* const none = edges.data() + edges.size();
  std::atomic<const FacetEdge*> firstOpen{ none };
  const double nanosecondsPerEdge = 2;
  ForBlocksOfEdges(edges, nanosecondsPerEdge,
    [&](const FacetEdge* begin, const FacetEdge* end)
    {
      ForEachEdge(begin, end,
        [&](const FacetEdge* first, const FacetEdge* last)
        {
          int sum = 0;
          for (const FacetEdge* edge = first; edge != last; ++edge)
          {
            sum += edge->Direction * sides[edge->Facet];
          }
          const FacetEdge* open = firstOpen;
          while (sum != 0 && first < open && !firstOpen.compare_exchange_weak(open, first))
          {
          }
        });
    });
  if (const FacetEdge* const open = firstOpen; open != none)
  {
    throw Error(ErrorCode::Inconsistent,
      "the boundary is open at the edge of points " + std::to_string(open->Low) + " and " +
        std::to_string(open->High));
  }
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
