// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
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
 * barycenter, unrounded if rounding would put it outside its triangle.
 *
 * @param[in] curve from which the mesh was made
 * @throws Error Stopped
 */
std::vector<double> WindingNumberOfTriangles(const SegmentComplex& curve, const PlanarMesh& mesh,
  const PlanarMetric& metric, Monitor& monitor);
} // namespace insideout
