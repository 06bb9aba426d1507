// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Planar/PlanarCurve.h"

namespace insideout
{
/**
 * Stage CDT in a plane: the constrained Delaunay triangulation of the convex hull, by CGAL. Its
 * points are the curve's, and each constraint is an edge: there are no Steiner points. Circles are
 * those of the metric.
 *
 * @param[in] curve resolved; no two points equal
 * @throws Error SelfIntersecting if constraints cross or a point lies within one; AllDegenerate if
 * all points lie on one line; Stopped
 */
PlanarMesh TriangulateHull(
  const SegmentComplex& curve, const PlanarMetric& metric, Monitor& monitor);
} // namespace insideout
