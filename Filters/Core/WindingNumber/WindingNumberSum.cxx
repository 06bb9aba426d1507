// SPDX-License-Identifier: GPL-3.0-or-later
//
// Facets are sorted along a space-filling curve and cut into tiles, so that the facets of a tile
// share their points; a batch of blocks of sites uses each tile while it is in the cache.
#include "WindingNumber/WindingNumberSum.h"

#include "Common/ChunkedLoop.h"
#include "Common/ScaledPoints.h"
#include "WindingNumber/SolidAngleTiles.h"
#include "WindingNumber/SpatialOrder.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace insideout
{
namespace
{
constexpr std::size_t SitesPerBatch = 8 * Lanes;

/** The facets with a count, sorted so that neighbors in space are near each other. */
std::vector<CountedTriangle> SortedFacets(const FacetComplex& surface)
{
  const std::vector<CountedTriangle> counted = CountedFacets(surface);
  std::vector<Point> centres;
  for (const CountedTriangle& triangle : counted)
  {
    Point centre = { 0, 0, 0 };
    for (const Id p : triangle.Corners)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        centre[axis] += surface.Points[p][axis] / 3;
      }
    }
    centres.push_back(centre);
  }
  std::vector<CountedTriangle> sorted;
  for (const Id i : SpatialOrder(centres))
  {
    sorted.push_back(counted[i]);
  }
  return sorted;
}

/** The sites from `first` on of `order`, one block of lanes at a time. */
void SumBatch(const SolidAngleTiles& tiles, TileRange all, const Sites& sites,
  const std::vector<Id>& order, std::size_t first, std::vector<double>& w)
{
  const std::size_t last = std::min(order.size(), first + SitesPerBatch);
  std::vector<SiteProducts> blocks;
  for (std::size_t i = first; i < last; i += Lanes)
  {
    blocks.push_back(MakeBlock(sites, order, i));
  }
  for (std::size_t tile = all.First; tile < all.Last; ++tile)
  {
    for (SiteProducts& block : blocks)
    {
      tiles.Multiply({ tile, tile + 1 }, sites, block);
    }
  }
  for (std::size_t i = first; i < last; ++i)
  {
    w[order[i]] =
      WindingNumber(blocks[(i - first) / Lanes].Product, static_cast<int>((i - first) % Lanes));
  }
}
} // namespace

std::vector<double> WindingNumberSum(
  const FacetComplex& surface, const Sites& sites, Monitor& monitor, const ProgressRange& progress)
{
  monitor.Check(progress.Stage, progress.Begin);
  const int exponent = std::max(LargestExponent(surface.Points), LargestExponent(sites.Points));
  const std::vector<Point> points = ScaledPoints(surface.Points, -exponent);
  const std::vector<Point> sitePoints = ScaledPoints(sites.Points, -exponent);
  const Sites scaledSites = { sitePoints, sites.Cells, sites.Weights };
  SolidAngleTiles tiles(points);
  const TileRange all = tiles.Add(SortedFacets(surface));
  std::vector<Id> order(sites.Cells.size());
  std::iota(order.begin(), order.end(), 0);
  std::vector<double> w(order.size(), 0.0);
  const Id batches = static_cast<Id>((order.size() + SitesPerBatch - 1) / SitesPerBatch);
  const double nanosecondsPerPair = 2;
  ChunkedLoop(batches, nanosecondsPerPair * SitesPerBatch * tiles.NumberOfTriangles(), monitor,
    progress,
    [&](Id batch) { SumBatch(tiles, all, scaledSites, order, batch * SitesPerBatch, w); });
  monitor.Check(progress.Stage, progress.End);
  return w;
}
} // namespace insideout
