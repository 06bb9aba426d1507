// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Box.h"
#include "Common/Monitor.h"
#include "Common/ProgressRange.h"
#include "WindingNumber/CountedBoundary.h"
#include "WindingNumber/GridPlaces.h"

namespace insideout
{
/**
 * The winding number of caps at all places of some slices of a grid.
 *
 * Away from a cap its winding number is a harmonic function, which a polynomial through few values
 * represents to rounding. So the slices are bisected recursively into boxes. Caps that are far from
 * a box are summed at the nodes of a polynomial in it; the others are summed in its halves, which
 * evaluate the polynomial at their own nodes. A box with no more places than nodes has its places
 * as nodes.
 */
class CapsInGrid
{
public:
  /**
   * For the slices from first to last (excluded).
   *
   * @param[in] points of the caps, below 1 in each coordinate
   * @param[in] caps each a chain of triangles that are not degenerate
   * @param[in] negligible where the caps' winding number is certainly below this, 0 is added
   * instead
   * @param[in] grid has to live as long as this object; below 2^50, its axes ascend strictly
   * @throws Error (Stopped)
   */
  CapsInGrid(const std::vector<Point>& points,
    const std::vector<std::vector<CountedTriangle>>& caps, double negligible,
    const GridPlaces& grid, Id first, Id last, Monitor& monitor, const ProgressRange& progress);

  /** Add the caps' winding number at each point of a slice, with an error of about 1e-14. Safe to
   * call from several threads. */
  void AddInSlice(Id slice, std::vector<double>& w) const;

private:
  /** The nodes of a polynomial along an axis. */
  struct AxisNodes
  {
    std::vector<double> Places;
    std::vector<double> Weights; ///< barycentric
  };

  /** A box of grid points, per axis from first to last (excluded). */
  struct GridBox
  {
    std::array<Id, 3> First;
    std::array<Id, 3> Last;
    std::array<AxisNodes, 3> Nodes;
    std::vector<double> Values; ///< at the nodes, x fastest; empty for zero
    std::vector<Id> Near;       ///< caps that are not in the values

    /** The values of the nodes' polynomials, place by place; for x node by node. */
    std::array<std::vector<double>, 3> Basis;
  };

  AxisNodes NodesOf(int axis, Id first, Id last) const;
  GridBox MakeBox(const std::array<Id, 3>& first, const std::array<Id, 3>& last) const;
  Box Around(const GridBox& box) const;
  bool IsFar(Id cap, const GridBox& box) const;
  double BoundIn(const GridBox& box) const;
  void AddFarCaps(GridBox& box) const;
  std::array<GridBox, 2> Halves(const GridBox& box) const;
  void FindBasis(GridBox& box) const;
  void AddInSlice(const GridBox& box, Id slice, std::vector<double>& w) const;

  static std::vector<double> BasisAt(const AxisNodes& nodes, double x);

  const std::vector<Point>& Points;
  const std::vector<std::vector<CountedTriangle>>& Caps;
  std::vector<Box> BoxOfCap;
  std::vector<double> AreaOfCap; ///< each repeated by its count
  const GridPlaces& Grid;
  std::vector<GridBox> Boxes; ///< boxes in which no cap is left out
};
} // namespace insideout
