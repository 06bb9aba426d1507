// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/BoxTree.h"
#include "WindingNumber/MultipoleTree.h"
#include "WindingNumber/SliverTree.h"
#include "WindingNumber/SolidAngleTiles.h"
#include "WindingNumber/StraightCapProduct.h"
#include "WindingNumber/StraightCaps.h"

#include <memory>
#include <mutex>

namespace insideout
{
/**
 * The winding number of the pieces that straight caps stand in for: that of the caps' triangles,
 * plus that of the slivers, plus a label. The label is 0, except at a site as near to a triangle as
 * its pieces are; there exact predicates find it.
 */
class WindingNumberOfStraightCaps
{
public:
  /**
   * @param[in] points of the caps, below 1 in each coordinate; both have to live as long as this
   * object
   * @param[in] sites how many will be asked for: many are worth a MultipoleTree
   * @throws Error (Stopped)
   */
  WindingNumberOfStraightCaps(const std::vector<Point>& points, const StraightCaps& caps,
    std::size_t sites, Monitor& monitor, const ProgressRange& progress);

  /**
   * Add the winding number at site order[i] to w[order[i]], for all i. Fastest
   * where neighbors in `order` are neighbors in space; the values do not depend on the number of
   * threads.
   *
   * @throws Error (Stopped)
   */
  void Add(const Sites& sites, const std::vector<Id>& order, std::vector<double>& w,
    Monitor& monitor, const ProgressRange& progress) const;

private:
  const BoxTree& TreeOf(std::size_t cap) const;
  void AddBlocks(const Sites& sites, const std::vector<Id>& order, std::size_t first,
    std::size_t last, SiteProducts* blocks, const MultipoleTree::Local& outer,
    std::vector<double>& w) const;
  void AddTriangles(const std::vector<Id>& groups, const Sites& sites, SiteProducts& block,
    double (&labels)[Lanes]) const;
  double MultiplyByUndecided(
    std::size_t triangle, const Site& site, Products& products, int lane) const;
  bool MayBeAmid(const StraightCap& cap, const RoundedSite& site) const;
  double Label(std::size_t cap, const Site& site) const;
  std::vector<CountedTriangle> ChainAround(std::size_t cap, const Box& box) const;

  const std::vector<Point>& Points;
  const StraightCaps& Caps;
  std::vector<CapTriangle> Triangles;        ///< each repeated by its count
  std::vector<std::size_t> CapOf;            ///< per triangle
  std::vector<std::size_t> FirstOfGroup;     ///< its first triangle; and the end
  std::unique_ptr<const MultipoleTree> Tree; ///< of the groups
  SliverTree Slivers;
  mutable std::vector<BoxTree> Trees; ///< per cap, made on demand
  std::unique_ptr<std::once_flag[]> IsTreeMade;
};
} // namespace insideout
