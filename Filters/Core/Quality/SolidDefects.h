// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/LayerCells.h"
#include "Common/Monitor.h"
#include "Common/Statistics.h"
#include "Common/Types.h"

#include <vector>

namespace insideout
{
/** The defects of cells, decided exactly: tetrahedra first, then pyramids and prisms of layers. */
struct SolidDefects
{
  /**
   * Per cell the sign of its volume in VTK's order of points: 1, 0 or -1. A pyramid or prism has
   * the sign of its worst corner (Orient).
   */
  std::vector<std::int8_t> Orientations;

  /**
   * Per cell its part of the solid, connected through faces; parts are numbered from 0 by their
   * first cells.
   */
  std::vector<Id> Regions;

  Id NumberOfRegions = 0;
  Id NegativeCells = 0;
  Id FlatCells = 0;

  Id CrowdedFaces = 0;     ///< of more than two cells
  Id OverlappingFaces = 0; ///< whose two cells lie on the same side

  std::vector<Tetrahedron> Parts; ///< the cells, those of layers cut into tetrahedra (AppendParts)
  std::vector<Triangle> Boundary; ///< the faces of exactly one cell, quads cut likewise

  /**
   * Pairs of boundary faces that meet beyond shared points and edges, and halves of quads that are
   * a triangle of another cell. Cells overlap there, or do not fit together, as at a point in the
   * middle of another cell's edge.
   */
  Id ContactPairs = 0;

  /**
   * Whether cells meet in whole faces only, without overlap. Then the boundary is watertight: it is
   * the sum of the cells' boundaries, in which inner faces cancel.
   */
  bool Conforms() const
  {
    return this->CrowdedFaces == 0 && this->OverlappingFaces == 0 && this->ContactPairs == 0;
  }
};

/**
 * The defects of tetrahedra, and of pyramids and prisms among them.
 *
 * @param[in] points finite coordinates
 * @param[in] cells and layers ids in range, different within a cell
 * @throws Error Stopped
 */
SolidDefects FindSolidDefects(const std::vector<Point>& points,
  const std::vector<Tetrahedron>& cells, const LayerCells& layers, Monitor& monitor);

/** Append the counts by name; Conforms is 1 or 0. */
void AppendSolidDefects(const SolidDefects& defects, Statistics& statistics);
} // namespace insideout
