// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/Statistics.h"
#include "Common/TetrahedralMesh.h"
#include "Layers/LayerColumns.h"

#include <vector>

namespace insideout
{
struct LayerParameters
{
  int Layers = 3;
  double FirstHeight = 0; ///< of the layer at the wall
  double Growth = 1.2;    ///< of a layer's height over that of the one before it
};

/** A solid with layers of prisms at a wall, of pyramids where one edge has no length, and
 * tetrahedra behind. */
struct LayeredMesh : LayerCells
{
  /** Those of the input that are left, with the wall's where they were, then those of the layers.
   */
  std::vector<Point> Points;
  std::vector<Id> OriginalPoints; ///< per point, that of the input; None for a new or moved one
  std::vector<Id> CellsOfPoints;  ///< per point, a cell of the input that holds it, or is near it

  /** Cells behind the layers first, then those of layers with two edges of no length. */
  std::vector<Tetrahedron> Tetrahedra;
  std::size_t NumberOfCellsBehind = 0; ///< of these tetrahedra

  /** Per cell, tetrahedra before pyramids before prisms: one of the input that holds it, or is
   * near it, of the same region; and its layer, from 1 at the wall, 0 behind. */
  std::vector<Id> OriginalCells;
  std::vector<Id> Layers;

  insideout::Statistics Statistics;
};

/**
 * Layers of prisms inside a part of the boundary, whose triangles stay bit by bit. At each of its
 * points all layers shrink alike where there is no room for them: in gaps, where the wall is bent,
 * beside the rest of the boundary and faces between regions to 0, so that no two layers meet. A
 * prism with an edge of no length is a pyramid, with two a tetrahedron. All other faces of the
 * boundary and between regions stay, too.
 *
 * Every cell is positive at its corners, exactly (Orient), each inner face is of two cells, and
 * together they fill the solid. The same result for the same input, always.
 *
 * Statistics: Layers, Prisms, Pyramids, LayerTetrahedra; WallTriangles, WallPoints, of these
 * ReducedPoints, whose layers are lower than asked for, and BarePoints without layers;
 * FullHeightShare, the share of the wall's area whose three points have full height, and
 * MeanHeightShare, the mean over its area of the share of the height.
 *
 * @param[in] mesh of any solid, as good and as large cells as those behind the layers are to be
 * @param[in] regions one per cell; empty: all are one
 * @param[in] wall faces without a second cell, 4 * cell + face, each once
 * @throws Error InvalidParameter, for parameters out of range, another number of regions, and a
 *   face that is none, has a second cell or is there twice; TooLarge; Stopped
 */
LayeredMesh MakeBoundaryLayers(const TetrahedralMesh& mesh, const std::vector<Id>& regions,
  const std::vector<Id>& wall, const LayerParameters& parameters, Monitor& monitor);
} // namespace insideout
