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
  const std::vector<double>& Heights;   ///< of the layers that there is to be room for
  const std::vector<double>& Fractions; ///< of the layers' borders
};

/**
 * Moves the points of a wall inward, whole or not at all each. After a move all cells of the mesh
 * and of the layers around are positive, exactly. The point has gone to the inner side of all
 * triangles of the moved wall around it. So the moved wall never crosses itself or the wall: each
 * move sweeps only cells around the point.
 */
class PushedWall
{
public:
  PushedWall(RefinableMesh& mesh, const WallPush& push);

  /**
   * Move each point on, at most about as far as its neighbors are.
   *
   * @param[in] share of the way that is left to go at once, where edges are shorter than it
   * @return the number of points moved
   */
  Id Advance(double share);

  /** Where a point of the wall was. */
  const Point& Outer(Id point) const { return this->Start[point]; }

  /** The height of the layers that there is room for now. */
  double Height(Id point) const { return this->Gone[point]; }

private:
  double MostAt(Id point) const;
  bool MoveTo(Id point, double height);
  bool IsInside(Id point, const Point& place) const;
  bool ArePositive(Id point, const Point& place) const;

  RefinableMesh& Mesh;
  const WallPush Push;
  std::vector<Point> Start; ///< of the points of the mesh when it began
  std::vector<double> Gone; ///< height of the layers at each
  std::vector<Id> Cells;
  std::vector<Triangle> Walls;
};
} // namespace insideout
