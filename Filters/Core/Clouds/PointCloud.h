// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/ProgressRange.h"
#include "Common/Types.h"

#include <vector>

namespace insideout
{
/** Points of a surface without its triangles, as a scanner gives them. */
struct PointCloud
{
  std::vector<Point> Points;
  std::vector<Point> Normals; ///< one per point, outward
  std::vector<double> Areas;  ///< what each point stands for; or none, where nobody knows them
};

/**
 * A cloud that can be asked: its normals have length 1, and its areas are known, by AreasOfPoints
 * where they were not.
 *
 * @throws Error that names the point (EmptySurface, PointNotFinite, InvalidParameter,
 * AllDegenerate), or (Stopped)
 */
PointCloud CheckedCloud(PointCloud cloud, Monitor& monitor, const ProgressRange& progress);

/**
 * Whether the normals of a cloud seem to point inward: it is nearly closed, so that the vector
 * areas of its points sum to a tenth of their areas at most, and encloses a volume below 0.
 *
 * @param[in] cloud that was checked
 */
bool SeemsInsideOut(const PointCloud& cloud);
} // namespace insideout
