// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Box.h"
#include "Common/ParallelLoop.h"
#include "WindingNumber/BoundaryProduct.h"
#include "WindingNumber/MultipoleTree.h"
#include "WindingNumber/SolidAngleTiles.h"

#include <memory>

namespace insideout
{
/**
 * The winding number of a chain of triangles that is small compared with the region of its query
 * points: the caps that close the holes of a surface.
 *
 * The chain is given in parts, its caps. A site takes the winding numbers of far caps from their
 * boundaries alone (BoundaryProduct.h), which give them modulo 1, in sums that are below 1/2 by
 * the caps' areas. The other caps are summed, triangle by triangle, with exact decisions on which
 * side of a triangle the site lies (SolidAngleProduct.h). Either way the value is exact up to
 * rounding and never off by one. Neighboring caps form a bunch, so that many small far caps cost no
 * more than a large one with as many edges; to many sites far bunches are multipoles
 * (MultipoleTree.h).
 */
class WindingNumberOfCaps
{
public:
  /**
   * @param[in] points of the caps, below 1 in each coordinate; has to live as long as this object
   * @param[in] caps each a chain of triangles that are not degenerate; connected ones serve best
   * @param[in] sites how many will be asked for: many are worth a MultipoleTree
   * @throws Error (Stopped)
   */
  WindingNumberOfCaps(const std::vector<Point>& points,
    const std::vector<std::vector<CountedTriangle>>& caps, std::size_t sites, Monitor& monitor,
    const ProgressRange& progress);

  /**
   * Add the winding number at site order[i] to w[order[i]], for all i. Fastest
   * where neighbors in `order` are neighbors in space; the values do not depend on the number of
   * threads.
   *
   * @param[in] sites below 2^50 in each coordinate
   * @throws Error (Stopped)
   */
  void Add(const Sites& sites, const std::vector<Id>& order, std::vector<double>& w,
    Monitor& monitor, const ProgressRange& progress) const;

  /** The winding number at one point. Safe to call from several threads. */
  double At(const Point& point) const;

  bool IsEmpty() const { return this->Caps.empty(); }

private:
  using Chain = std::vector<CountedTriangle>;

  /** A cap or several. */
  struct Part
  {
    Box Around;
    double Area; ///< counted as often as the triangles
    TileRange Triangles;
    std::size_t FirstPoint; ///< of the boundary, in LoopPoints
    std::size_t FirstSize;  ///< of its loops, in LoopSizes
    std::size_t LastSize;
  };
  /** Neighboring caps. */
  struct Bunch
  {
    Part Whole;
    std::size_t FirstCap;
    std::size_t LastCap;
  };
  struct BoundedPart
  {
    const Part* Taken;
    double Bound; ///< of |w| at the sites
  };
  struct Chosen
  {
    MultipoleTree::Local Outer;       ///< of the bunches, around many blocks
    MultipoleTree::Local Inner;       ///< of the rest, around fewer
    MultipoleTree::Selection Bunches; ///< of the rest, for one block
    std::vector<BoundedPart> Parts;   ///< of the near ones
  };

  void AddBunches(const Chain** first, const Chain** last, std::vector<Chain>& bunches);
  void AddBunch(const Chain* const* first, const Chain* const* last, std::vector<Chain>& bunches);
  void Measure(const Chain& triangles, Part& part) const;
  void AddLoops(const std::vector<Loop>& loops, Part& cap);
  void Choose(
    const Ball& sites, const std::vector<Id>& bunches, std::vector<BoundedPart>& parts) const;
  void MultiplyByFar(
    const Part& part, const Ball& ball, const SiteBlock& sites, PhaseProducts& products) const;
  void AddBlock(const Sites& sites, const std::vector<Id>& order, std::size_t first,
    SiteProducts& block, Chosen& chosen, std::vector<double>& w) const;

  const std::vector<Point>& Points;
  SolidAngleTiles Triangles;
  std::vector<Bunch> Bunches;
  std::unique_ptr<const MultipoleTree> Tree; ///< of the bunches
  std::vector<Part> Caps;
  std::vector<Point> LoopPoints; // of loop after loop
  std::vector<std::int32_t> LoopSizes;
};
} // namespace insideout
