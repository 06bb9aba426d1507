// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Layers/LayerWall.h"
#include "Layers/WallDirections.h"

#include <vector>

namespace insideout
{
/** How much heights may differ between neighbors, per length of the edge between them. */
constexpr double GradingOfHeights = 1;

/** The distance from a point of the wall, along its direction, at which layers of a height end: in
 * corners it is longer, up to twice as long. 0 where there is no direction. */
double LengthOfHeight(const WallDirection& direction, double height);

/**
 * How far layers may go from each point of a wall: as far as the height asks for, but at most a
 * third of the way to the facet ahead. Edges keep a quarter of their length, and neighbors are
 * graded. One value per point of the mesh, 0 where there is no direction.
 */
std::vector<double> LimitHeights(const RefinableMesh& mesh, const LayerWall& wall,
  const std::vector<WallDirection>& directions, double height);
} // namespace insideout
