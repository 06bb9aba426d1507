// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Layers/LayerHeights.h"
#include "Layers/LayerWall.h"
#include "Layers/WallDirections.h"

#include <vector>

namespace insideout
{
/** Distances and directions by which the points of a wall move. */
struct WallPush
{
  const LayerWall& Wall;
  const std::vector<WallDirection>& Directions;
  const std::vector<double>& Heights;   ///< of the layers to make room for
  const std::vector<double>& Fractions; ///< of the layers' borders
};

/**
 * Moves the points of a wall inward, whole or not at all each. After a move all cells of the mesh
 * and of the layers around are positive, exactly, and no triangle is tilted by more than 60 degrees
 * (up to rounding). The point has gone to the inner side of all triangles of the moved wall around
 * it. So the moved wall never crosses itself or the wall: each move sweeps only cells around the
 * point.
 */
class PushedWall
{
public:
  PushedWall(RefinableMesh& mesh, const WallPush& push);

  /**
   * Advance each point, at most about as far as its neighbors.
   *
   * @param[in] share of the remaining way to go at once, if edges are shorter than that
   *
   * @return the number of points moved
   */
  Id Advance(double share);

  /** The initial position of a point of the wall. */
  const Point& Outer(Id point) const { return this->Start[point]; }

  /** The present height of the layers at a point. */
  double Height(Id point) const { return this->Gone[point]; }

private:
  double MostAt(Id point) const;
  bool MoveTo(Id point, double height);
  bool IsInside(Id point, const Point& place) const;
  bool AreGood(Id point, const Point& place) const;

  RefinableMesh& Mesh;
  const WallPush Push;
  std::vector<Point> Start; ///< initial positions of the mesh's points
  std::vector<double> Gone; ///< height of the layers at each
  std::vector<Id> Cells;
  std::vector<Triangle> Walls;
};
} // namespace insideout
