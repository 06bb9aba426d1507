// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Output/BoundaryTriangles.h"

namespace insideout
{
/**
 * Merge the pieces of an input triangle if all of it lies on the boundary, with one orientation,
 * and nothing else needs the points that this drops: no other triangle has a point inside it, and
 * triangles along its edges are merged too, so that the boundary stays watertight.
 *
 * @param[in] triangles of a watertight boundary
 * @param[in] given the input triangles by points of the mesh (TrianglesInMesh)
 * @return the triangles in their order, each merged one at the position of its first piece
 * @throws Error Stopped
 */
std::vector<BoundaryTriangle> MergePieces(const std::vector<BoundaryTriangle>& triangles,
  const std::vector<Triangle>& given, Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
