// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/Statistics.h"
#include "Common/TetrahedralMesh.h"
#include "Refine/SizingField.h"

#include <vector>

namespace insideout
{
/** Better cells of the same solid. */
struct RefinedMesh
{
  std::vector<Point> Points;
  std::vector<Tetrahedron> Cells;
  std::vector<Id>
    OriginalPoints; ///< per point, the one of the input that it is, None for a new one

  /** Per cell, the one of the input that holds its barycentre; of the same region. */
  std::vector<Id> OriginalCells;

  /** Per point, a cell of the input that holds it. */
  std::vector<Id> CellsOfPoints;

  insideout::Statistics Statistics;
};

/**
 * Tetrahedra of the same solid that are better and as large as asked for. Every face of the
 * boundary, and every face between two regions, stays as it is, bit by bit. Delaunay refinement by
 * lengths (FillWithPoints), then the worst cells are improved (ImproveCells). Every cell has a
 * positive volume, exactly; the same result for the same input, always.
 *
 * Statistics: AddedPoints and RemovedPoints, CellsAboveMaximumVolume, where that is given.
 *
 * @param[in] mesh of any solid; its facets do not matter
 * @param[in] regions one per cell; empty: all are one
 * @throws Error InvalidParameter, which names the culprit (a cell without volume, two that overlap
 * at a face, a length that is not positive), TooLarge when there would be more cells than can be
 * counted, Stopped
 */
RefinedMesh RefineTetrahedra(const TetrahedralMesh& mesh, const std::vector<Id>& regions,
  const SizingParameters& parameters, Monitor& monitor);
} // namespace insideout
