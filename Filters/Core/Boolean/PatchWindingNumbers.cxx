// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/PatchWindingNumbers.h"

#include "Common/ParallelLoop.h"
#include "Common/RawVector.h"
#include "Common/ScaledPoints.h"
#include "Common/Vectors.h"
#include "WindingNumber/ClosedChainTree.h"
#include "WindingNumber/WindingNumbersAtFew.h"

#include <cmath>
#include <numeric>

namespace insideout
{
namespace
{
std::vector<double> WindingNumbersAtMany(const std::vector<Point>& points,
  const std::vector<CountedTriangle>& chain, const Sites& sites, Monitor& monitor,
  const ProgressRange& progress)
{
  const std::size_t count = sites.Cells.size();
  std::vector<Point> wanted;
  for (std::size_t i = 0; i < count; ++i)
  {
    wanted.push_back(sites.Rounded(i).High);
  }
  const double middle = progress.At(0.5);
  const ClosedChainTree tree(
    points, chain, wanted, monitor, { progress.Stage, progress.Begin, middle });
  std::vector<Id> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::vector<double> w(count);
  tree.Evaluate(sites, order, w, monitor, { progress.Stage, middle, progress.End });
  return w;
}
} // namespace

PatchPlaces::PatchPlaces(const FacetComplex& surface, const SurfacePatches& patches)
  : Points(ScaledPoints(surface.Points, -LargestExponent(surface.Points)))
  , Largest(static_cast<std::size_t>(patches.Count), None)
{
  const double nanosecondsPerFacet = 15;
  RawVector<double> areas(surface.Facets.size());
  ParallelLoop(areas.size(), nanosecondsPerFacet,
    [&](std::size_t f)
    {
      const std::array<Point, 3> corners = CornersOf(this->Points, surface.Facets[f]);
      areas[f] = Length(NormalOf(corners[0], corners[1], corners[2]));
    });
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    Id& largest = this->Largest[patches.Patch[f]];
    largest = largest == None || areas[f] > areas[largest] ? f : largest;
  }
  // The barycenter of a cell with two equal corners lies in the facet, exactly.
  for (const Id f : this->Largest)
  {
    const Triangle& facet = surface.Facets[f];
    this->Middles.push_back({ { facet[0], facet[1], facet[2], facet[2] } });
  }
}

std::vector<PatchSides> PatchPlaces::WindingNumbers(const std::vector<CountedTriangle>& chain,
  const std::vector<int>& counts, Monitor& monitor, const ProgressRange& progress) const
{
  const Sites sites = { this->Points, this->Middles };
  const std::vector<double> means = this->Middles.size() <= MostFewSites
    ? WindingNumbersAtFew(this->Points, chain, sites, monitor, progress)
    : WindingNumbersAtMany(this->Points, chain, sites, monitor, progress);
  std::vector<PatchSides> sides;
  for (std::size_t patch = 0; patch < means.size(); ++patch)
  {
    const double half = counts[patch] / 2.0;
    const int front = static_cast<int>(std::lround(means[patch] - half));
    sides.push_back({ front, front + counts[patch] });
  }
  return sides;
}
} // namespace insideout
