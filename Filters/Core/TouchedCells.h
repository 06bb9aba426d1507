// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "CountedBoundary.h"
#include "TetrahedralMesh.h"

namespace insideout
{
/**
 * For each cell, 1 where one of the triangles may touch it. With exact predicates: a cell that is
 * 0 has no point in common with any of them. A few cells are 1 that are only close to a triangle:
 * those that no plane of a face separates from it.
 *
 * @param[in] triangles between points of the mesh
 */
std::vector<char> TouchedCells(
  const TetrahedralMesh& mesh, const std::vector<CountedTriangle>& triangles);
} // namespace insideout
