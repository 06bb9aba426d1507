// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/TetrahedralMesh.h"

namespace insideout
{
/**
 * A mesh of tetrahedra from anywhere, with their neighbors and no facets. Cells that are
 * negatively oriented get their last two corners swapped, by which their faces 0 and 3 change
 * places.
 *
 * @param[in] cells ids in range
 * @throws Error InvalidParameter, which names three cells that share a face
 */
TetrahedralMesh ConnectCells(std::vector<Point> points, std::vector<Tetrahedron> cells);
} // namespace insideout
