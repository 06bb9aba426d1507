// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/ProgressRange.h"
#include "Common/Types.h"

#include <vector>

namespace insideout
{
/**
 * How much of a surface each of its points stands for, as Barill, Dickson, Schmidt, Levin and
 * Jacobson (2018) estimate it: the area of the point's Voronoi cell among its nearest neighbors,
 * all seen in the point's tangent plane; here within the neighbors' convex hull, so that on the
 * rim of an open surface nothing beyond it counts. Neighbors are those that face the same way, so
 * that the other side of a thin wall is none. Points in one place share its area.
 *
 * @param[in] points finite
 * @param[in] normals one per point, of length 1
 * @return one area per point, in squared units; 0 where all neighbors are in a line with the point
 * @throws Error (Stopped)
 */
std::vector<double> AreasOfPoints(const std::vector<Point>& points,
  const std::vector<Point>& normals, Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
