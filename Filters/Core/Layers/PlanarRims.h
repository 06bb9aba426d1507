// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Layers/WallRims.h"
#include "Planar/PlanarCurve.h"

#include <vector>

namespace insideout
{
/** An edge that cells behind layers keep. */
struct PlanarConstraint
{
  Segment Ends; ///< as they run in a cell
  Id Edge;      ///< 3 * cell + edge of this cell
  Id Label;
  bool IsOuter; ///< there is no other cell
  bool IsWall;
};

/** A straight part of the boundary that begins or ends at a wall, whose layers go along it. */
struct PlanarRun
{
  std::vector<Id> Points; ///< as the boundary runs, with the solid on its left
  std::vector<Id> Edges;  ///< from each to the next, 3 * cell + edge
  bool BeginsAtWall;
  bool EndsAtWall;
};

/** Where a wall of edges meets the rest of the boundary in a plane. */
struct PlanarRims
{
  std::vector<PlanarConstraint> Constraints; ///< but for those of runs
  std::vector<WallRim> AtPoints;             ///< per point of the mesh
  std::vector<PlanarRun> Runs;
};

/**
 * Find the rims of a wall in a plane. A point of the wall where one edge of the boundary goes on
 * that is none of the wall begins a run: edges of one label that are straight up to WallRims'
 * angle, without another constraint at the points between. Points are held where other constraints
 * meet, and where the run leads outward from the wall.
 *
 * @param[in] flat the mesh's points by orthonormal coordinates, the third of which is 0
 * @param[in] mesh, wall as MakePlanarLayers has them
 */
PlanarRims FindPlanarRims(
  const std::vector<Point>& flat, const PlanarMesh& mesh, const std::vector<Id>& wall);
} // namespace insideout
