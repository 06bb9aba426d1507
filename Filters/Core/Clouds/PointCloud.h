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
  std::vector<double> Areas;  ///< the area that each point represents; or empty, if unknown
};

/**
 * A cloud ready for queries: normals have length 1, and missing areas are set by AreasOfPoints.
 *
 * @throws Error that names the point (EmptySurface, PointNotFinite, InvalidParameter,
 * AllDegenerate), or (Stopped)
 */
PointCloud CheckedCloud(PointCloud cloud, Monitor& monitor, const ProgressRange& progress);

/**
 * Whether the normals of a cloud seem to point inward: it is nearly closed (its points' vector
 * areas sum to at most a tenth of their areas), and encloses a negative volume.
 *
 * @param[in] cloud with normals of length 1 and areas
 */
bool SeemsInsideOut(const PointCloud& cloud);
} // namespace insideout
