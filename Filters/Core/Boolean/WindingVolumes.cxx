// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/WindingVolumes.h"

#include "Boolean/PatchBoundary.h"
#include "Common/Stages.h"

namespace insideout
{
std::optional<WindingVolumes> VolumesWithin(const FacetComplex& surface, Monitor& monitor)
{
  const std::vector<CountedTriangle> chain = CountedFacets(surface);
  if (surface.NumberOfConstraints < surface.NumberOfFacets() ||
    !CountedBoundary(chain, static_cast<Id>(surface.Points.size())).empty())
  {
    return std::nullopt;
  }
  const FacetEdges edges = SortedFacetEdges(surface.Facets);
  const SurfacePatches patches = FindPatches(surface, edges);
  const PatchPlaces places(surface, patches);
  std::vector<int> counts;
  for (Id patch = 0; patch < patches.Count; ++patch)
  {
    counts.push_back(surface.Multiplicity[places.FacetOf(patch)]);
  }
  const std::vector<PatchSides> sides =
    places.WindingNumbers(chain, counts, monitor, { Stages::WindingNumbers, 0, 1 });
  const std::vector<int> countOfFacet(surface.Multiplicity.begin(), surface.Multiplicity.end());
  const auto volumeWhere = [&](int least)
  {
    std::vector<HoldsBeside> holds;
    for (const PatchSides& side : sides)
    {
      holds.push_back({ side.Front >= least, side.Back >= least });
    }
    return VolumeWithin(
      surface.Points, PatchBoundary(surface, edges, patches, places, holds, countOfFacet));
  };
  return WindingVolumes{ volumeWhere(1), volumeWhere(2) };
}
} // namespace insideout
