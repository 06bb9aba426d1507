// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Layers/LayerWall.h"
#include "Layers/WallRims.h"

#include <vector>

namespace insideout
{
/** Which way the layers go at a point of a wall. */
struct WallDirection
{
  Point Inward = { { 0, 0, 0 } }; ///< of length 1
  double Cosine = 0; ///< the least with the inner normals of the triangles around; 0: no way in

  /** How long the way through layers of height 1 is: in corners longer. */
  double LengthPerHeight() const;

  /** The product of this way and a vector. */
  double WayAlong(const Point& vector) const;
};

/**
 * One direction per point of the mesh, for those of the wall: the one whose least cosine with the
 * triangles' normals is largest (Aubry and Loehner 2008), of those along the planes of other facets
 * at its point; smoothed along the wall as far as that cosine allows, and farther where edges would
 * get short behind layers of the height.
 */
std::vector<WallDirection> FindWallDirections(const std::vector<Point>& points,
  const LayerWall& wall, const std::vector<WallRim>& rims, double height);
} // namespace insideout
