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
/** How good tetrahedra are, all together. Angles are dihedral, in degrees. All 0 without cells. */
struct MeshQuality
{
  Id Cells = 0;

  double MinDihedralAngle = 0;

  /** The 1 % quantile of the six angles of all cells: the least that is no less than a hundredth of
   * them. */
  double DihedralAngle1Percent = 0;
  double MaxDihedralAngle = 0;

  double RadiusEdgeRatio99Percent = 0; ///< the least that is no less than 99 % of them
  double MaxRadiusEdgeRatio = 0;       ///< infinite where a cell is flat

  double MinMeanRatio = 0;
  double AverageMeanRatio = 0;

  Id CellsUnder10Degrees = 0; ///< that have an angle below
  Id CellsUnder5Degrees = 0;

  /** Edges of the boundary where the solid itself is so sharp: at each of them cells have to be. A
   * wedge of the solid between two boundary faces counts once, so that an edge may count twice. */
  Id SurfaceEdgesUnder10Degrees = 0;
  Id SurfaceEdgesUnder5Degrees = 0;

  /** The number of angles per 5 degrees, from 0; 180 is in the last. */
  std::array<std::int64_t, 36> Histogram = {};
};

/** The quality of each cell. */
std::vector<CellQuality> QualityOfCells(const std::vector<Point>& points,
  const std::vector<Tetrahedron>& cells, Monitor& monitor, const ProgressRange& progress);

/** Where the solid is sharp: a wedge of it between two boundary faces. */
struct SharpEdge
{
  Edge Ends;
  double Angle; ///< in degrees, through the solid: the sum of its cells' dihedral angles
};

/**
 * The wedges of the solid with an angle below a limit, by their first cell. A face of one cell is
 * on the boundary; behind a face of more than two there is no telling, and no wedge is found.
 *
 * @param[in] cells ids in range, each with four different ones
 * @param[in] qualities of each cell (QualityOfCells)
 * @param[in] limit in degrees
 */
std::vector<SharpEdge> SharpBoundaryEdges(const std::vector<Tetrahedron>& cells,
  const std::vector<CellQuality>& qualities, std::size_t numberOfPoints, double limit);

/**
 * The quality of all cells together; the same bits for any number of threads.
 *
 * @param[in] points finite coordinates
 * @param[in] cells ids in range, each with four different ones
 * @throws Error Stopped
 */
MeshQuality QualityOfMesh(const std::vector<Point>& points, const std::vector<Tetrahedron>& cells,
  Monitor& monitor, const ProgressRange& progress);

/** The same of cells whose qualities are known. */
MeshQuality SummarizeQuality(const std::vector<Tetrahedron>& cells,
  const std::vector<CellQuality>& qualities, std::size_t numberOfPoints, Monitor& monitor,
  const ProgressRange& progress);

/** All but the histogram and the number of cells under their names, with a word in front
 * ("Before"). */
void AppendQuality(
  const MeshQuality& quality, Statistics& statistics, const std::string& prefix = "");
} // namespace insideout
