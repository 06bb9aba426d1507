// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Edge.h"
#include "Common/Monitor.h"
#include "Common/Statistics.h"
#include "Quality/CellQuality.h"

#include <cstdint>
#include <vector>

namespace insideout
{
/** The quality of all tetrahedra together. Angles are dihedral, in degrees. All 0 without cells. */
struct MeshQuality
{
  Id Cells = 0;

  double MinDihedralAngle = 0;

  /** The 1 % quantile of the six angles of all cells. */
  double DihedralAngle1Percent = 0;
  double MaxDihedralAngle = 0;

  double RadiusEdgeRatio99Percent = 0; ///< the 99 % quantile
  double MaxRadiusEdgeRatio = 0;       ///< infinite if a cell is flat

  double MinMeanRatio = 0;
  double AverageMeanRatio = 0;

  Id CellsUnder10Degrees = 0; ///< cells with an angle below 10 degrees
  Id CellsUnder5Degrees = 0;

  /**
   * Edges of the boundary at which the solid itself has an angle below 10 degrees, so that cells
   * there have one, too. A wedge of the solid between two boundary faces counts once, so an edge
   * may count twice.
   */
  Id SurfaceEdgesUnder10Degrees = 0;
  Id SurfaceEdgesUnder5Degrees = 0;

  /** The number of angles per 5 degrees, from 0; 180 is in the last. */
  std::array<std::int64_t, 36> Histogram = {};
};

/** The quality of each cell. */
std::vector<CellQuality> QualityOfCells(const std::vector<Point>& points,
  const std::vector<Tetrahedron>& cells, Monitor& monitor, const ProgressRange& progress);

/** A sharp edge of the solid: a wedge between two boundary faces. */
struct SharpEdge
{
  Edge Ends;
  double Angle; ///< in degrees, through the solid: the sum of its cells' dihedral angles
};

/**
 * The wedges of the solid with an angle below a limit, by their first cell. Faces of exactly one
 * cell are on the boundary. A wedge with a face of more than two cells is skipped.
 *
 * @param[in] cells ids in range, each with four different ones
 * @param[in] qualities of each cell (QualityOfCells)
 * @param[in] limit in degrees
 */
std::vector<SharpEdge> SharpBoundaryEdges(const std::vector<Tetrahedron>& cells,
  const std::vector<CellQuality>& qualities, std::size_t numberOfPoints, double limit);

/**
 * The quality of all cells together. The result does not depend on the number of threads.
 *
 * @param[in] points finite coordinates
 * @param[in] cells ids in range, each with four different ones
 * @throws Error Stopped
 */
MeshQuality QualityOfMesh(const std::vector<Point>& points, const std::vector<Tetrahedron>& cells,
  Monitor& monitor, const ProgressRange& progress);

/** The same for cells whose qualities are known. */
MeshQuality SummarizeQuality(const std::vector<Tetrahedron>& cells,
  const std::vector<CellQuality>& qualities, std::size_t numberOfPoints, Monitor& monitor,
  const ProgressRange& progress);

/**
 * Append all figures by name, with a prefix ("Before"), except the histogram and the number of
 * cells.
 */
void AppendQuality(
  const MeshQuality& quality, Statistics& statistics, const std::string& prefix = "");
} // namespace insideout
