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
 * For a closed curve it is carried from triangle to triangle, from 0 beyond the hull, rising by
 * what each segment counts: whole numbers, exactly. Otherwise it is that of PolylineWindingNumber
 * at the barycenter: the exact one, where rounding would put it out of its triangle.
 *
 * @param[in] curve which the mesh was made of
 * @throws Error Stopped
 */
std::vector<double> WindingNumberOfTriangles(const SegmentComplex& curve, const PlanarMesh& mesh,
  const PlanarMetric& metric, Monitor& monitor);
} // namespace insideout
