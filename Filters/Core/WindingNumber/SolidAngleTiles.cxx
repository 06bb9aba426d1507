// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/SolidAngleTiles.h"

#include "Common/SortUniquely.h"
#include "Common/Vectors.h"
#include "WindingNumber/Prefetch.h"
#include "WindingNumber/SolidAngle.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
namespace
{
// Prefetch distance in a block: cells are scattered over memory.
constexpr std::size_t BlocksAhead = 2;

constexpr std::size_t FacetsPerTile = 128; // their unit vectors for a block fit in the L1 cache
} // namespace

SiteProducts MakeBlock(const Sites& sites, const std::vector<Id>& order, std::size_t first)
{
  SiteProducts block;
  SiteCorners corners;
  for (int lane = 0; lane < Lanes; ++lane)
  {
    const std::size_t i = static_cast<std::size_t>(order[std::min(first + lane, order.size() - 1)]);
    block.Index[lane] = i;
    const Tetrahedron& cell = sites.Cells[i];
    Prefetch(&sites.Cells[order[std::min(first + BlocksAhead * Lanes + lane, order.size() - 1)]]);
    for (int k = 0; k < 4; ++k)
    {
      const Point& corner = sites.Points[cell[k]];
      for (int axis = 0; axis < 3; ++axis)
      {
        corners.Of[k][axis][lane] = corner[axis];
      }
    }
    block.Product.Real[lane] = 1;
    block.Product.Imaginary[lane] = 0;
    block.Product.Turns[lane] = 0;
  }
  SetSites(block.Rounded, corners, sites.Weights);
  return block;
}

std::vector<SiteProducts> MakeBlocks(
  const Sites& sites, const std::vector<Id>& order, std::size_t first, std::size_t last)
{
  std::vector<SiteProducts> blocks;
  for (std::size_t i = first; i < last; i += Lanes)
  {
    blocks.push_back(MakeBlock(sites, order, i));
  }
  return blocks;
}

SolidAngleTiles::SolidAngleTiles(const std::vector<Point>& points)
  : Points(points)
{
}

void SolidAngleTiles::CloseTile(std::size_t firstFacet)
{
  std::vector<Id> ids;
  for (std::size_t f = firstFacet; f < this->Facets.size(); ++f)
  {
    ids.insert(ids.end(), this->Facets[f].Corners.begin(), this->Facets[f].Corners.end());
  }
  SortUniquely(ids);
  for (std::size_t f = firstFacet; f < this->Facets.size(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->Facets[f].Local[k] = IndexIn(ids, this->Facets[f].Corners[k]);
    }
  }
  const std::size_t firstPoint = this->TilePoints.size();
  for (Id id : ids)
  {
    this->TilePoints.push_back(this->Points[id]);
  }
  this->Tiles.push_back({ firstPoint, this->TilePoints.size(), firstFacet, this->Facets.size() });
}

TileRange SolidAngleTiles::Add(const std::vector<CountedTriangle>& triangles)
{
  TileRange range;
  range.First = this->Tiles.size();
  std::size_t first = this->Facets.size();
  for (const CountedTriangle& triangle : triangles)
  {
    SummedFacet facet;
    facet.Corners = FromBluntCorner(this->Points, triangle.Corners);
    if (triangle.Count < 0)
    {
      std::swap(facet.Corners[1], facet.Corners[2]);
    }
    facet.Local = facet.Corners;
    SetGeometry(facet, this->Points[facet.Corners[0]], this->Points[facet.Corners[1]],
      this->Points[facet.Corners[2]]);
    for (int i = 0; i < std::abs(triangle.Count); ++i)
    {
      this->Facets.push_back(facet);
      if (this->Facets.size() - first == FacetsPerTile)
      {
        this->CloseTile(first);
        first = this->Facets.size();
      }
    }
  }
  if (first < this->Facets.size())
  {
    this->CloseTile(first);
  }
  range.Last = this->Tiles.size();
  return range;
}

void SolidAngleTiles::MultiplyByUndecided(const SummedFacet& facet, const Sites& sites,
  const double (&undecided)[Lanes], SiteProducts& block) const
{
  const std::array<Point, 3> triangle = CornersOf(this->Points, facet.Corners);
  for (int lane = 0; lane < Lanes; ++lane)
  {
    if (undecided[lane] > 0)
    {
      const std::complex<double> z = HalfSolidAngle(triangle, sites[block.Index[lane]]);
      MultiplyBy(block.Product, lane, z.real(), z.imag());
    }
  }
}

void SolidAngleTiles::Multiply(TileRange tiles, const Sites& sites, SiteProducts& block) const
{
  UnitVectors vectors[3 * FacetsPerTile];
  for (std::size_t t = tiles.First; t < tiles.Last; ++t)
  {
    const Tile& tile = this->Tiles[t];
    ComputeUnitVectors(
      &this->TilePoints[tile.FirstPoint], tile.LastPoint - tile.FirstPoint, block.Rounded, vectors);
    const SummedFacet* facet = &this->Facets[tile.FirstFacet];
    const SummedFacet* const last = facet + (tile.LastFacet - tile.FirstFacet);
    while (facet != last)
    {
      double undecided[Lanes] = {};
      facet = MultiplyByFacets(facet, last, vectors, block.Product, undecided);
      this->MultiplyByUndecided(facet[-1], sites, undecided, block);
    }
  }
}
} // namespace insideout
