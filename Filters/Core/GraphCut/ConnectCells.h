// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/TetrahedralMesh.h"

namespace insideout
{
/**
 * A mesh of given tetrahedra, with their neighbors and without facets. Negatively oriented cells
 * get their last two corners swapped, which swaps their faces 0 and 3.
 *
 * @param[in] cells ids in range
 * @throws Error InvalidParameter, which names three cells that share a face
 */
TetrahedralMesh ConnectCells(std::vector<Point> points, std::vector<Tetrahedron> cells);
} // namespace insideout
