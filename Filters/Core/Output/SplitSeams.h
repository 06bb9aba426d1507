// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Output/BoundaryTriangles.h"

namespace insideout
{
/** A surface with possibly coincident points. */
struct SeamedSurface
{
  std::vector<Triangle> Triangles;  ///< by the points below
  std::vector<Id> Places;           ///< the coincident point of the mesh, per point
  std::vector<PointOrigin> Origins; ///< one per point
};

/**
 * Undo the merging of points: each boundary triangle gets the corners of the input triangle that it
 * lies on, as they were before merging, and new points interpolate these. Triangles share a point
 * if their data there are equal. Where a hole was closed, the point of the lowest adjacent input
 * triangle is taken.
 *
 * @param[in] triangles of the boundary
 * @param[in] given the input triangles by points of the mesh (TrianglesInMesh)
 * @param[in] alike per point of the soup the lowest one with which it was merged and whose data are
 *            the same
 * @return points sorted by position, then by input triangle
 * @throws Error Stopped
 */
SeamedSurface SplitSeams(const std::vector<BoundaryTriangle>& triangles, const TriangleSoup& soup,
  const std::vector<Triangle>& given, const std::vector<Id>& alike, const TetrahedralMesh& mesh,
  Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
