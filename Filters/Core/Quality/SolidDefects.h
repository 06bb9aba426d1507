// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/Statistics.h"
#include "Common/Types.h"

#include <vector>

namespace insideout
{
/** The defects of tetrahedra, decided exactly. */
struct SolidDefects
{
  /** For each cell: 1 where its volume is positive as vtkTetra orders its points, 0 where it is
   * flat, -1 where it is negative. */
  std::vector<std::int8_t> Orientations;

  /** For each cell the part of the solid that it is in, parts being joined through faces: from 0,
   * by their first cells. */
  std::vector<Id> Regions;

  Id NumberOfRegions = 0;
  Id NegativeCells = 0;
  Id FlatCells = 0;

  Id CrowdedFaces = 0;     ///< of more than two cells
  Id OverlappingFaces = 0; ///< whose two cells lie on the same side

  std::vector<Triangle> Boundary; ///< the faces of one cell

  /** Pairs of boundary faces that meet beyond the points and edges that they share: where cells
   * overlap, or do not fit together, as at a point in the middle of another cell's edge. */
  Id ContactPairs = 0;

  /** Whether cells meet in whole faces only, without overlap. The boundary is watertight then: a
   * sum of the boundaries of cells, of which what is within cancels. */
  bool Conforms() const
  {
    return this->CrowdedFaces == 0 && this->OverlappingFaces == 0 && this->ContactPairs == 0;
  }
};

/**
 * The defects of tetrahedra.
 *
 * @param[in] points finite coordinates
 * @param[in] cells ids in range, each with four different ones
 * @throws Error Stopped
 */
SolidDefects FindSolidDefects(
  const std::vector<Point>& points, const std::vector<Tetrahedron>& cells, Monitor& monitor);

/** The counts under their names; Conforms is 1 or 0. */
void AppendSolidDefects(const SolidDefects& defects, Statistics& statistics);
} // namespace insideout
