// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/RepairedSurface.h"

#include "Common/Stages.h"
#include "WindingNumber/WindingNumberOfCells.h"

#include <algorithm>

namespace insideout
{
namespace
{
std::vector<int> CountsBesidePatches(
  const FacetComplex& surface, const PatchPlaces& places, Id numberOfPatches)
{
  std::vector<int> counts;
  for (Id patch = 0; patch < numberOfPatches; ++patch)
  {
    counts.push_back(surface.Multiplicity[places.FacetOf(patch)]);
  }
  return counts;
}

std::vector<OutlierPiece> OutliersOf(const FacetComplex& surface, const SurfacePatches& patches,
  const std::vector<HoldsBeside>& isInside)
{
  std::vector<OutlierPiece> outliers;
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    const HoldsBeside& sides = isInside[patches.Patch[f]];
    if (!sides.Front && !sides.Back)
    {
      outliers.push_back({ surface.Facets[f], f, OutlierReason::Energy });
    }
  }
  return outliers;
}
} // namespace

std::optional<RepairedSurface> RepairSurface(const FacetComplex& surface, Monitor& monitor)
{
  if (surface.NumberOfConstraints < surface.NumberOfFacets() || !IsClosed(surface))
  {
    return std::nullopt;
  }
  const std::vector<FacetEdge> edges = SortedFacetEdges(surface.Facets);
  const SurfacePatches patches = FindPatches(surface, edges);
  const PatchPlaces places(surface, patches);
  const std::vector<PatchSides> w = places.WindingNumbers(CountedFacets(surface),
    CountsBesidePatches(surface, places, patches.Count), monitor, { Stages::WindingNumbers, 0, 1 });
  RepairedSurface repaired;
  std::vector<HoldsBeside> isInside;
  for (const PatchSides& sides : w)
  {
    isInside.push_back({ sides.Front >= 1, sides.Back >= 1 });
    repaired.MinimumW = std::min({ repaired.MinimumW, sides.Front, sides.Back });
    repaired.MaximumW = std::max({ repaired.MaximumW, sides.Front, sides.Back });
  }
  repaired.Boundary = PatchBoundary(surface, edges, patches, places, isInside,
    { surface.Multiplicity.begin(), surface.Multiplicity.end() });
  repaired.Outliers = OutliersOf(surface, patches, isInside);
  monitor.Check(Stages::Extracting, 1);
  return repaired;
}

bool IsCutByWholeNumbers(const GraphCutParameters& cut)
{
  const GraphCutParameters most;
  return cut.DataTerm == DataTerm::Uniform && cut.Gamma <= most.Gamma && cut.Sigma <= most.Sigma;
}
} // namespace insideout
