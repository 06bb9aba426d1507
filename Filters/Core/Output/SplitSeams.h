// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Output/BoundaryTriangles.h"

namespace insideout
{
/** A surface whose points may stand in one place several times. */
struct SeamedSurface
{
  std::vector<Triangle> Triangles;  ///< by the points below
  std::vector<Id> Places;           ///< the point of the mesh where each point stands
  std::vector<PointOrigin> Origins; ///< one per point
};

/**
 * Give points that were merged back to the input triangles: each boundary triangle gets the corners
 * of the input triangle that it lies on, as they were before merging, and new points interpolate
 * these. Triangles share a point where what they have there is alike. Where a hole was closed the
 * point of the lowest input triangle around is taken.
 *
 * @param[in] triangles of the boundary
 * @param[in] given the input triangles by points of the mesh (TrianglesInMesh)
 * @param[in] alike per point of the soup the lowest one with which it was merged and whose data are
 *            the same
 * @return points by the place where they stand, then by input triangle
 * @throws Error Stopped
 */
SeamedSurface SplitSeams(const std::vector<BoundaryTriangle>& triangles, const TriangleSoup& soup,
  const std::vector<Triangle>& given, const std::vector<Id>& alike, const TetrahedralMesh& mesh,
  Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
