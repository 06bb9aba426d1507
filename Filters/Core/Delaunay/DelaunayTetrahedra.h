// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Delaunay/InsertionOrder.h"
#include "Delaunay/InsertionRounds.h"

#include <vector>

namespace insideout
{
/**
 * The Delaunay tetrahedra of points, and tetrahedra between the faces of their hull and a vertex at
 * infinity, so that each face has two. Points on a common sphere are taken as IsInSphere says.
 * Cells and their order depend on the points alone, not on the number of threads.
 */
class DelaunayTetrahedra
{
public:
  /** Neighbor k is across from corner k. */
  struct Cell
  {
    Tetrahedron Corners; ///< points, positive; the infinite vertex, points.size(), lies outside
    std::array<Id, 4> Neighbors;
  };

  /**
   * @param[in] points finite
   * @param[in] most cells there may be
   * @param[in] progress that the monitor hears of
   * @throws Error Planar, TooLarge, Stopped
   */
  DelaunayTetrahedra(const std::vector<Point>& points, std::size_t most, Monitor& monitor,
    const ProgressRange& progress);

  Id NumberOfCells() const { return static_cast<Id>(this->IdOf.size()); }
  Cell At(Id cell) const;

  /** Per point the first one in its place: only that one has cells. */
  const std::vector<Id>& FirstInPlace() const { return this->First; }

private:
  void JoinCoincident(const std::vector<Coincidence>& coincidences);
  void Rename(const std::vector<Id>& names);
  void NumberCells();

  InsertionOrder Order;
  DelaunayCells Cells;
  std::vector<Id> First;
  std::vector<Id> PointOf;  ///< per vertex
  std::vector<Id> IdOf;     ///< per cell its id among Cells
  std::vector<Id> NumberOf; ///< the inverse
};
} // namespace insideout
