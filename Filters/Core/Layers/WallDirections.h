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
  double Cosine = 0; ///< the least with the inner normals of the facets around; 0: none inward

  /** The length of an edge through layers of height 1: longer in corners. */
  double LengthPerHeight() const;

  /** The way to the facet ahead that layers of a height need, and the height for which a way is
   * enough. Layers take a third of a gap. */
  double EnoughWay(double height) const;
  double HeightBefore(double way) const;

  /** The product of this direction and a vector. */
  double WayAlong(const Point& vector) const;
};

/** The normals of a wall's triangles, of length 1. */
std::vector<Point> InwardNormals(const std::vector<Point>& points, const LayerWall& wall);

/**
 * One direction per point of the wall: the one with the largest minimal cosine to the facets'
 * normals (Aubry and Loehner 2008), among those along the planes of other facets at the point.
 * Directions are smoothed along the wall as far as that cosine allows, and farther if edges behind
 * the layers would get short.
 *
 * @param[in] normals per facet, inward, of length 1
 * @param[in] rims per point of the mesh
 */
std::vector<WallDirection> FindWallDirections(const std::vector<Point>& points,
  const WallPoints& wall, const std::vector<Point>& normals, const std::vector<WallRim>& rims,
  double height);
} // namespace insideout
