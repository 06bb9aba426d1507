// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Output/BoundaryTriangles.h"

namespace insideout
{
/**
 * Put the pieces of an input triangle back together where all of it lies on the boundary, facing
 * one way, and nothing else needs the points that this drops: no other triangle has a point inside
 * it, and those along its edges are put together too, so that the boundary stays watertight.
 *
 * @param[in] triangles of a watertight boundary
 * @param[in] given the input triangles by points of the mesh (TrianglesInMesh)
 * @return the triangles in their order, each that was put together in the place of its first piece
 * @throws Error Stopped
 */
std::vector<BoundaryTriangle> MergePieces(const std::vector<BoundaryTriangle>& triangles,
  const std::vector<Triangle>& given, Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
