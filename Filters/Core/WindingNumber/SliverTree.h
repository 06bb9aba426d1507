// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Box.h"
#include "WindingNumber/SolidAngleTiles.h"
#include "WindingNumber/StraightCapProduct.h"

namespace insideout
{
/**
 * Triangles about as thin as rounding errors, in a tree of boxes. Nodes too small to be seen from a
 * site are left out: a node's winding number is at most its area over that of the sphere around the
 * site which touches its box.
 */
class SliverTree
{
public:
  /** @param[in] points below 1 in each coordinate; has to live as long as this object */
  SliverTree(const std::vector<Point>& points, const std::vector<CountedTriangle>& slivers);

  /** The slivers that may be seen from some sites. */
  struct Selection
  {
    std::vector<Id> Slivers;
    std::vector<SliverLines> Lines; ///< of these
  };

  /** The slivers that may be seen from sites whose rounded positions are in a box. */
  Selection Select(const Box& box) const;

  /** Add half the solid angles of all to each site's sum. The block is made of `sites`, and of
   * sites that the selection is for. */
  void Add(const Selection& selection, const Sites& sites, const SiteProducts& block,
    double (&sums)[Lanes]) const;

private:
  /** Nodes stand in depth-first order; an inner node holds no slivers itself (First = Last). */
  struct Node
  {
    Box Bounds;
    double Area; ///< over that of a sphere of radius 1
    std::size_t First;
    std::size_t Last;
    std::size_t Lines; ///< of its slivers
    std::size_t Next;  ///< the next node when this one is skipped
  };

  void Build(std::size_t first, std::size_t last);
  void AddOne(
    std::size_t sliver, const Sites& sites, const SiteProducts& block, double (&sums)[Lanes]) const;

  std::vector<Sliver> Slivers;
  std::vector<int> Counts; ///< of these
  std::vector<SliverLines> Lines;
  std::vector<Node> Nodes;
};

/** The box of a block's sites, rounded. */
Box BoxOfSites(const SiteBlock& sites);
} // namespace insideout
