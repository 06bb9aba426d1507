// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Layers/LayerWall.h"
#include "Layers/WallDirections.h"

#include <vector>

namespace insideout
{
/** Limit on the difference of heights of neighbors, per length of their edge. */
constexpr double GradingOfHeights = 1;

/**
 * The largest heights of layers at each point of a wall: the height asked for, but at most a third
 * of the way to the facet ahead. Edges keep a quarter of their length, and neighbors are graded.
 * Counts the points in gaps that are too narrow. One value per point of the mesh, 0 where there is
 * no direction.
 */
std::vector<double> LimitHeights(const RefinableMesh& mesh, const LayerWall& wall,
  const std::vector<WallDirection>& directions, double height, Id& narrow);
} // namespace insideout
