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
  /** For each cell the sign of its volume in VTK's order of points: 1, 0 or -1. A pyramid or prism
   * is as its worst corner (Orient). */
  std::vector<std::int8_t> Orientations;

  /** For each cell its part of the solid, connected through faces; parts are numbered from 0 by
   * their first cells. */
  std::vector<Id> Regions;

  Id NumberOfRegions = 0;
  Id NegativeCells = 0;
  Id FlatCells = 0;

  Id CrowdedFaces = 0;     ///< of more than two cells
  Id OverlappingFaces = 0; ///< whose two cells lie on the same side

  std::vector<Tetrahedron> Parts; ///< the cells, those of layers cut (AppendParts)
  std::vector<Triangle> Boundary; ///< the faces of one cell, quads cut with it

  /** Pairs of boundary faces that meet beyond the points and edges that they share: where cells
   * overlap, or do not fit together, as at a point in the middle of another cell's edge; and quads'
   * halves that are a triangle of another cell. */
  Id ContactPairs = 0;

  /** Whether cells meet in whole faces only, without overlap. The boundary is watertight then: it
   * is the sum of the cells' boundaries, in which inner faces cancel. */
  bool Conforms() const
  {
    return this->CrowdedFaces == 0 && this->OverlappingFaces == 0 && this->ContactPairs == 0;
  }
};

/**
 * The defects of tetrahedra, and of pyramids and prisms among them.
 *
 * @param[in] points finite coordinates
 * @param[in] cells ids in range, each with different ones, as in layers
 * @throws Error Stopped
 */
SolidDefects FindSolidDefects(const std::vector<Point>& points,
  const std::vector<Tetrahedron>& cells, const LayerCells& layers, Monitor& monitor);

/** The counts under their names; Conforms is 1 or 0. */
void AppendSolidDefects(const SolidDefects& defects, Statistics& statistics);
} // namespace insideout
