// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "GraphCut/RealEnergy.h"

namespace insideout
{
/** Parts of cells of any shape (all volumes or all polygons): their sides, or simplices. */
struct CellParts
{
  std::vector<Id> Cells;                    ///< the cell of each part, ascending
  std::vector<std::size_t> Offsets = { 0 }; ///< start in Corners per part, and the end
  std::vector<Id> Corners;

  template <typename Ids>
  void Add(Id cell, const Ids& corners)
  {
    this->Cells.push_back(cell);
    this->Corners.insert(this->Corners.end(), corners.begin(), corners.end());
    this->Offsets.push_back(this->Corners.size());
  }
};

/**
 * The sides with the same corners in two cells, each once, with its area, or length if the cells
 * are polygons.
 *
 * @param[in] sides faces of volumes, corners as they run around, or edges of polygons
 * @throws Error InvalidParameter, which names three cells that share a side
 */
std::vector<InteriorFace> SharedSides(const std::vector<Point>& points, const CellParts& sides);

/**
 * The volume of each cell, or the area where the cells are polygons.
 *
 * @param[in] simplices tetrahedra, or triangles, that the cells consist of
 */
std::vector<double> CellSizes(
  const std::vector<Point>& points, const CellParts& simplices, Id numberOfCells);
} // namespace insideout
