// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "WindingNumber/ClosedChainTree.h"
#include "WindingNumber/GridPlaces.h"
#include "WindingNumber/HoleCaps.h"
#include "WindingNumber/WindingNumberOfCaps.h"

#include <optional>

namespace insideout
{
/**
 * The winding number of any chain of triangles at any place, exact but for the rounding of its
 * fraction.
 *
 * The chain's holes are closed with caps (HoleCaps.h). Then
 *
 *   w = winding number of (chain - caps) + winding number of caps
 *
 * where the first is a whole number. A tree (ClosedChainTree.h) finds it in time that grows with
 * the logarithm of the number of triangles. The second costs a few operations per open edge
 * (WindingNumberOfCaps.h), nothing where the chain is closed. Values do not depend on the numbering
 * of points.
 *
 * On the chain w is the mean of its values around the place, weighted by solid angle.
 */
class ExactWindingNumber
{
public:
  /**
   * @param[in] points below 1 in each coordinate; has to live as long as this object
   * @param[in] triangles not degenerate
   * @param[in] boundary theirs
   * @param[in] sites how many will be asked for; for many the values of caps depend on this number
   * @throws Error (Stopped)
   */
  ExactWindingNumber(const std::vector<Point>& points, std::vector<CountedTriangle> triangles,
    const std::vector<CountedEdge>& boundary, Monitor& monitor, const ProgressRange& progress,
    std::size_t sites = 0);
  ExactWindingNumber(const ExactWindingNumber&) = delete;
  void operator=(const ExactWindingNumber&) = delete;

  /**
   * The winding number at each point; the values do not depend on the number of threads.
   *
   * @param[in] at below 2^50 in each coordinate
   * @throws Error (Stopped)
   */
  std::vector<double> Evaluate(
    const std::vector<Point>& at, Monitor& monitor, const ProgressRange& progress) const;

  /** The same at sites, which doubles need not represent. */
  std::vector<double> Evaluate(
    const Sites& sites, Monitor& monitor, const ProgressRange& progress) const;

  /**
   * At all places of a grid, slice by slice: the whole number along rows (LabelsInRows.h), the
   * caps' by polynomials (CapsInGrid.h). Few slices are held at once.
   *
   * @param[in] grid below 2^50 in each coordinate; its axes ascend strictly
   * @param[in] sideOf if given, values only tell on which side of it the winding number is; an open
   * surface then takes no longer than a closed one
   * @throws Error (Stopped)
   */
  void EvaluateInGrid(const GridPlaces& grid, std::optional<double> sideOf,
    const SliceVisitor& visit, Monitor& monitor, const ProgressRange& progress) const;

  /** The winding number at one point. Safe to call from several threads. */
  double At(const Point& point) const;

private:
  const NumberedCaps Caps;
  const ClosedChainTree Tree;
  const WindingNumberOfCaps SumOfCaps;
};
} // namespace insideout
