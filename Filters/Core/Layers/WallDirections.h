// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Layers/LayerWall.h"
#include "Layers/WallRims.h"

#include <vector>

namespace insideout
{
/** The direction of the layers at a point of a wall. */
struct WallDirection
{
  Point Inward = { { 0, 0, 0 } }; ///< of length 1
  double Cosine = 0; ///< the least with the inner normals of the triangles around; 0: none inward

  /** The length of an edge through layers of height 1: longer in corners. */
  double LengthPerHeight() const;

  /** The product of this direction and a vector. */
  double WayAlong(const Point& vector) const;
};

/**
 * One direction per point of the wall: the one with the largest minimal cosine to the triangles'
 * normals (Aubry and Loehner 2008), among those along the planes of other facets at the point.
 * Directions are smoothed along the wall as far as that cosine allows, and farther if edges behind
 * the layers would get short.
 */
std::vector<WallDirection> FindWallDirections(const std::vector<Point>& points,
  const LayerWall& wall, const std::vector<WallRim>& rims, double height);
} // namespace insideout
