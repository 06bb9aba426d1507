// SPDX-License-Identifier: GPL-3.0-or-later
//
// Facets are sorted along a space-filling curve and cut into tiles, so that the facets of a tile
// share their points; a batch of blocks of cells uses each tile while it is in the cache.
#include "WindingNumberSum.h"

#include "SolidAngle.h"
#include "SolidAngleProduct.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <exception>

namespace insideout
{
namespace
{
constexpr int BlocksPerBatch = 8;
constexpr int FacetsPerTile = 128; // their unit vectors for a block fit in the first cache

struct Tile
{
  std::size_t FirstPoint, LastPoint;
  std::size_t FirstFacet, LastFacet;
};

/**
 * All facets that count, in tiles: turned over where their multiplicity is negative, repeated where
 * it is above 1. With coordinates scaled into [-1, 1] by a power of two.
 */
struct TiledFacets
{
  std::vector<Tile> Tiles;
  std::vector<SummedFacet> Facets;
  std::vector<Point> Points; // of tile after tile
};

/** The exponent e such that all coordinates are below 2^e. */
int LargestExponent(const std::vector<Point>& a, const std::vector<Point>& b)
{
  double largest = 0;
  for (const std::vector<Point>* points : { &a, &b })
  {
    for (const Point& p : *points)
    {
      largest = std::max({ largest, std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
    }
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  return exponent;
}

Point Scaled(const Point& p, int exponent)
{
  return { std::ldexp(p[0], -exponent), std::ldexp(p[1], -exponent), std::ldexp(p[2], -exponent) };
}

/** The facets that count, in an order that keeps neighbours together. */
std::vector<Id> OrderAlongCurve(const FacetComplex& surface, const std::vector<Point>& scaled)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_3> centres;
  std::vector<std::size_t> order;
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    const Point& a = scaled[surface.Facets[f][0]];
    const Point& b = scaled[surface.Facets[f][1]];
    const Point& c = scaled[surface.Facets[f][2]];
    centres.emplace_back(a[0] + (b[0] + c[0]), a[1] + (b[1] + c[1]), a[2] + (b[2] + c[2]));
    if (surface.Multiplicity[f] != 0)
    {
      order.push_back(f);
    }
  }
  const auto map = CGAL::make_property_map(centres);
  CGAL::hilbert_sort(
    order.begin(), order.end(), CGAL::Spatial_sort_traits_adapter_3<Kernel, decltype(map)>(map));
  return std::vector<Id>(order.begin(), order.end());
}

/** Close the tile of the facets from `first` on: number their points and copy those. */
void AddTile(TiledFacets& tiled, std::size_t first, const std::vector<Point>& scaled)
{
  std::vector<Id> ids;
  for (std::size_t f = first; f < tiled.Facets.size(); ++f)
  {
    ids.insert(ids.end(), tiled.Facets[f].Corners.begin(), tiled.Facets[f].Corners.end());
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  for (std::size_t f = first; f < tiled.Facets.size(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      tiled.Facets[f].Local[k] = static_cast<int>(
        std::lower_bound(ids.begin(), ids.end(), tiled.Facets[f].Corners[k]) - ids.begin());
    }
  }
  const std::size_t firstPoint = tiled.Points.size();
  for (Id id : ids)
  {
    tiled.Points.push_back(scaled[id]);
  }
  tiled.Tiles.push_back({ firstPoint, tiled.Points.size(), first, tiled.Facets.size() });
}

TiledFacets MakeTiles(const FacetComplex& surface, int exponent)
{
  std::vector<Point> scaled;
  scaled.reserve(surface.Points.size());
  for (const Point& p : surface.Points)
  {
    scaled.push_back(Scaled(p, exponent));
  }
  TiledFacets tiled;
  std::size_t first = 0;
  for (Id f : OrderAlongCurve(surface, scaled))
  {
    const int multiplicity = surface.Multiplicity[f];
    Triangle corners = surface.Facets[f];
    if (multiplicity < 0)
    {
      std::swap(corners[1], corners[2]);
    }
    SummedFacet facet;
    facet.Corners = corners;
    facet.Local = corners;
    SetGeometry(facet, scaled[corners[0]], scaled[corners[1]], scaled[corners[2]]);
    for (int i = 0; i < std::abs(multiplicity); ++i)
    {
      tiled.Facets.push_back(facet);
      if (tiled.Facets.size() - first == FacetsPerTile)
      {
        AddTile(tiled, first, scaled);
        first = tiled.Facets.size();
      }
    }
  }
  if (first < tiled.Facets.size())
  {
    AddTile(tiled, first, scaled);
  }
  return tiled;
}

/** The cells of one block, their barycentres and products. */
struct Block
{
  std::array<std::array<Point, 4>, Lanes> Cells; // as they are, not scaled
  Barycentres Centres;
  Products Product;
};

/** Everything that the sums need, for all threads. */
struct Problem
{
  const FacetComplex& Surface;
  const std::vector<Point>& Points;
  const std::vector<Tetrahedron>& Cells;
  int Exponent;
  TiledFacets Tiled;
};

/** The cells from `first` on; the last one again and again where there are no more. */
Block MakeBlock(const Problem& problem, std::size_t first)
{
  Block block;
  for (int lane = 0; lane < Lanes; ++lane)
  {
    const std::size_t cell = std::min(first + lane, problem.Cells.size() - 1);
    std::array<Point, 4> scaled;
    for (int k = 0; k < 4; ++k)
    {
      block.Cells[lane][k] = problem.Points[problem.Cells[cell][k]];
      scaled[k] = Scaled(block.Cells[lane][k], problem.Exponent);
    }
    SetBarycentre(block.Centres, lane, scaled);
    block.Product.Real[lane] = 1;
    block.Product.Imaginary[lane] = 0;
    block.Product.Turns[lane] = 0;
  }
  return block;
}

/** Multiply by the facet in the cells where doubles did not decide. */
void MultiplyByUndecided(
  const Problem& problem, const SummedFacet& facet, const double (&undecided)[Lanes], Block& block)
{
  const std::array<Point, 3> triangle = { problem.Surface.Points[facet.Corners[0]],
    problem.Surface.Points[facet.Corners[1]], problem.Surface.Points[facet.Corners[2]] };
  for (int lane = 0; lane < Lanes; ++lane)
  {
    if (undecided[lane] > 0)
    {
      const std::complex<double> z = HalfSolidAngle(triangle, block.Cells[lane]);
      MultiplyBy(block.Product, lane, z.real(), z.imag());
    }
  }
}

void MultiplyByTile(
  const Problem& problem, const Tile& tile, std::vector<UnitVectors>& vectors, Block& block)
{
  const std::size_t points = tile.LastPoint - tile.FirstPoint;
  ComputeUnitVectors(&problem.Tiled.Points[tile.FirstPoint], points, block.Centres, vectors.data());
  const SummedFacet* facet = &problem.Tiled.Facets[tile.FirstFacet];
  const SummedFacet* const last = facet + (tile.LastFacet - tile.FirstFacet);
  while (facet != last)
  {
    double undecided[Lanes] = {};
    facet = MultiplyByFacets(facet, last, vectors.data(), block.Product, undecided);
    MultiplyByUndecided(problem, facet[-1], undecided, block);
  }
}

/** The winding numbers of the cells of one batch, from `first` on. */
void SumBatch(const Problem& problem, std::size_t first, std::vector<double>& w)
{
  std::vector<Block> blocks;
  for (int b = 0; b < BlocksPerBatch && first + b * Lanes < w.size(); ++b)
  {
    blocks.push_back(MakeBlock(problem, first + b * Lanes));
  }
  std::vector<UnitVectors> vectors(3 * FacetsPerTile);
  for (const Tile& tile : problem.Tiled.Tiles)
  {
    for (Block& block : blocks)
    {
      MultiplyByTile(problem, tile, vectors, block);
    }
  }
  const std::size_t last = std::min(w.size(), first + blocks.size() * Lanes);
  for (std::size_t cell = first; cell < last; ++cell)
  {
    w[cell] = WindingNumber(
      blocks[(cell - first) / Lanes].Product, static_cast<int>((cell - first) % Lanes));
  }
}

/** Some batches on all threads; what one of them throws is thrown when all are done. */
void SumBatches(
  const Problem& problem, std::int64_t firstBatch, std::int64_t lastBatch, std::vector<double>& w)
{
  std::exception_ptr failure;
#pragma omp parallel for schedule(dynamic)
  for (std::int64_t batch = firstBatch; batch < lastBatch; ++batch)
  {
    try
    {
      SumBatch(problem, static_cast<std::size_t>(batch) * BlocksPerBatch * Lanes, w);
    }
    catch (...)
    {
#pragma omp critical(WindingNumberSumFailure)
      failure = std::current_exception();
    }
  }
  if (failure)
  {
    std::rethrow_exception(failure);
  }
}
} // namespace

std::vector<double> WindingNumberSum(const FacetComplex& surface, const std::vector<Point>& points,
  const std::vector<Tetrahedron>& cells, Monitor& monitor)
{
  const char* stage = "winding numbers";
  monitor.Check(stage, 0);
  const int exponent = LargestExponent(surface.Points, points);
  const Problem problem = { surface, points, cells, exponent, MakeTiles(surface, exponent) };
  std::vector<double> w(cells.size(), 0.0);

  // Some tenths of a second between two looks at the monitor.
  const std::int64_t pairsPerChunk = std::int64_t(1) << 27;
  const std::int64_t cellsPerBatch = BlocksPerBatch * Lanes;
  const std::int64_t facets = static_cast<std::int64_t>(problem.Tiled.Facets.size());
  const std::int64_t chunk =
    std::max<std::int64_t>(16, pairsPerChunk / (cellsPerBatch * (facets + 1)));
  const std::int64_t batches =
    (static_cast<std::int64_t>(cells.size()) + cellsPerBatch - 1) / cellsPerBatch;
  for (std::int64_t batch = 0; batch < batches; batch += chunk)
  {
    monitor.Check(stage, static_cast<double>(batch) / batches);
    SumBatches(problem, batch, std::min(batches, batch + chunk), w);
  }
  monitor.Check(stage, 1);
  return w;
}
} // namespace insideout
