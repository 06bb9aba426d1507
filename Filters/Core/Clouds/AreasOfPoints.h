// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/ProgressRange.h"
#include "Common/Types.h"

#include <vector>

namespace insideout
{
/**
 * The area that each point of a surface represents, as estimated by Barill, Dickson, Schmidt, Levin
 * and Jacobson (2018): the area of the point's Voronoi cell among its nearest neighbors, all
 * projected to the point's tangent plane. Cells are limited to the neighbors' convex hull, so that
 * they do not extend beyond the rim of an open surface. Neighbors face the same way, which excludes
 * the other side of a thin wall. Coincident points share their area.
 *
 * @param[in] points finite
 * @param[in] normals one per point, of length 1
 * @return one area per point, in squared units; 0 if all neighbors are in a line with the point
 * @throws Error (Stopped)
 */
std::vector<double> AreasOfPoints(const std::vector<Point>& points,
  const std::vector<Point>& normals, Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
