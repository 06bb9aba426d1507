// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "GraphCutSegmentation.h"
#include "TetrahedralMesh.h"

namespace insideout
{
/**
 * The faces between two cells of the mesh, each once, for the cut's smoothness term. Their areas
 * are in units of the square of a power of two near the largest coordinate.
 */
std::vector<InteriorFace> InteriorFaces(const TetrahedralMesh& mesh);
} // namespace insideout
