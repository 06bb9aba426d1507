// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/LayerCells.h"
#include "Common/Statistics.h"
#include "Common/TetrahedralMesh.h"

#include <array>
#include <vector>

namespace insideout
{
/** A face of layers beside their wall, on another facet. */
struct LayerSide
{
  std::array<Id, 4>
    Corners; ///< counter-clockwise seen from outside; the last is None of a triangle
  Id Face;   ///< of the input, 4 * cell + face: one of the facet
};

/** A solid with layers of prisms at a wall, of pyramids where one edge has no length, and
 * tetrahedra behind. */
struct LayeredMesh : LayerCells
{
  /** The remaining points of the input, with the wall's unmoved, then the points of the layers. */
  std::vector<Point> Points;
  std::vector<Id>
    OriginalPoints; ///< per point, its number in the input; None for a new or moved one
  std::vector<Id> CellsOfPoints; ///< per point, an input cell that contains it or is near it

  /**
   * Per point of the input, the point that replaces it in facets other than the wall; None for a
   * removed one. At rims it is behind the layers.
   */
  std::vector<Id> PointsBeside;
  std::vector<LayerSide> Sides; ///< along other facets, between these and the wall

  /** Cells behind the layers first, then prisms that have lost two edges. */
  std::vector<Tetrahedron> Tetrahedra;
  std::size_t NumberOfCellsBehind = 0; ///< of these tetrahedra

  /**
   * Per cell, tetrahedra before pyramids before prisms: an input cell of the same region that
   * contains it or is near it, and its layer: 1 at the wall, 0 behind the layers.
   */
  std::vector<Id> OriginalCells;
  std::vector<Id> Layers;

  insideout::Statistics Statistics;
};
} // namespace insideout
