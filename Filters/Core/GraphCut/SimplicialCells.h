// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/TetrahedralMesh.h"

#include <cmath>
#include <functional>

namespace insideout
{
/** Volumes, or areas, scaled to prevent overflow and underflow. */
struct ScaledSizes
{
  std::vector<double> Scaled; ///< one per cell
  int Exponent;               ///< times 2 to this power they are in the units of the points

  double InUnits(double scaled) const { return std::ldexp(scaled, this->Exponent); }
};

/** Tetrahedra or triangles, with their connectivity. */
class SimplicialCells
{
public:
  /** Ids in contiguous memory. */
  struct Range
  {
    const Id* First;
    const Id* Last;
    const Id* begin() const { return this->First; }
    const Id* end() const { return this->Last; }
  };

  /**
   * @param[in] sizes measures the cells on demand
   * @param[in] opposite for each side of a cell the corner that is not on it
   */
  template <std::size_t Corners>
  SimplicialCells(std::size_t points, const std::vector<std::array<Id, Corners>>& cells,
    const std::vector<std::array<Id, Corners>>& neighbors, const std::array<int, Corners>& opposite,
    std::function<ScaledSizes()> sizes)
    : NumberOfPoints(points)
    , NumberOfCorners(Corners)
    , MeasureSizes(std::move(sizes))
    , Points(Corners * cells.size())
    , Neighbors(Corners * cells.size())
  {
    for (std::size_t c = 0; c < cells.size(); ++c)
    {
      for (std::size_t k = 0; k < Corners; ++k)
      {
        this->Points[c * Corners + k] = cells[c][k];
        this->Neighbors[c * Corners + opposite[k]] = neighbors[c][k];
      }
    }
  }

  std::size_t size() const { return this->Points.size() / this->NumberOfCorners; }

  /** The neighbors of a cell, each at the index of the opposite corner; None on the hull. */
  Range operator[](Id cell) const { return this->Of(this->Neighbors, cell); }

  Range CornersOf(Id cell) const { return this->Of(this->Points, cell); }

  ScaledSizes Sizes() const { return this->MeasureSizes(); }

  const std::size_t NumberOfPoints;
  const std::size_t NumberOfCorners; ///< per cell: 4, or 3 in a plane

private:
  Range Of(const std::vector<Id>& ids, Id cell) const
  {
    const Id* const first = ids.data() + static_cast<std::size_t>(cell) * this->NumberOfCorners;
    return { first, first + this->NumberOfCorners };
  }

  std::function<ScaledSizes()> MeasureSizes;
  std::vector<Id> Points;
  std::vector<Id> Neighbors;
};
} // namespace insideout
