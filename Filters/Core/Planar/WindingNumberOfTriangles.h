// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/ProgressRange.h"
#include "Planar/PlanarCurve.h"

#include <vector>

namespace insideout
{
/**
 * Stage w in a plane: the winding number of a curve in each triangle, positive where the curve runs
 * counter-clockwise around it.
 *
 * For a closed curve it is carried from triangle to triangle, from 0 outside the hull, adding each
 * segment's count: exact whole numbers. Otherwise PolylineWindingNumber is evaluated at the
 * barycenter.
 *
 * @param[in] curve from which the mesh was made
 * @throws Error Stopped
 */
std::vector<double> WindingNumberOfTriangles(const SegmentComplex& curve, const PlanarMesh& mesh,
  const PlanarMetric& metric, Monitor& monitor);

/**
 * PolylineWindingNumber at the barycenters of any triangles, such as those of a refined mesh; at
 * the unrounded ones where rounding would leave the triangle. Segments may cross triangles.
 *
 * @param[in] points, cells counter-clockwise triangles, with coordinates of the curve's plane
 * @return one value per cell
 * @throws Error Stopped
 */
std::vector<double> WindingNumberOfOtherTriangles(const SegmentComplex& curve,
  const std::vector<PlanarPoint>& points, const std::vector<Triangle>& cells,
  const PlanarMetric& metric, Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
