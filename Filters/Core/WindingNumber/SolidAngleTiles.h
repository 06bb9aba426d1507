// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "WindingNumber/CountedBoundary.h"
#include "WindingNumber/SolidAngleProduct.h"

#include <vector>

namespace insideout
{
/** A block of sites, and its partial product. */
struct SiteProducts
{
  std::array<std::size_t, Lanes> Index; ///< of the sites, in the list that they come from
  SiteBlock Rounded;
  Products Product;
};

/** A part of the tiles. */
struct TileRange
{
  std::size_t First = 0;
  std::size_t Last = 0;
};

/** The block of the sites from `first` on of `order`; the last site is repeated at the end. */
SiteProducts MakeBlock(const Sites& sites, const std::vector<Id>& order, std::size_t first);

/** The blocks of the sites from `first` up to `last`. */
std::vector<SiteProducts> MakeBlocks(
  const Sites& sites, const std::vector<Id>& order, std::size_t first, std::size_t last);

/**
 * Triangles prepared for the product of SolidAngleProduct.h. Triangles that share points are
 * grouped in a tile, whose unit vectors fit in the L1 cache: a block of sites computes them once
 * per tile.
 */
class SolidAngleTiles
{
public:
  /**
   * @param[in] points of all triangles, below 1 in each coordinate; has to live as long as the
   * tiles
   */
  explicit SolidAngleTiles(const std::vector<Point>& points);

  /** Put these triangles into new tiles, reversed if their count is negative and repeated if it is
   * above 1. Triangles next to each other in space should be next to each other. */
  TileRange Add(const std::vector<CountedTriangle>& triangles);

  /** Multiply each site's product by the triangles of some tiles. The block is made of `sites`. */
  void Multiply(TileRange tiles, const Sites& sites, SiteProducts& block) const;

  std::size_t NumberOfTriangles() const { return this->Facets.size(); }

private:
  struct Tile
  {
    std::size_t FirstPoint, LastPoint;
    std::size_t FirstFacet, LastFacet;
  };

  void CloseTile(std::size_t firstFacet);
  void MultiplyByUndecided(const SummedFacet& facet, const Sites& sites,
    const double (&undecided)[Lanes], SiteProducts& block) const;

  const std::vector<Point>& Points;
  std::vector<Tile> Tiles;
  std::vector<SummedFacet> Facets;
  std::vector<Point> TilePoints; // of tile after tile
};
} // namespace insideout
