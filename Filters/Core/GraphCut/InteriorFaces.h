// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/TetrahedralMesh.h"
#include "GraphCut/RealEnergy.h"

namespace insideout
{
/**
 * The faces between two cells of the mesh, each once, for the cut's smoothness term. Their areas
 * are in units of the square of a power of two near the largest coordinate.
 */
std::vector<InteriorFace> InteriorFaces(const TetrahedralMesh& mesh);

/** The volume of each cell, in units of the cube of that power of two. */
std::vector<double> CellVolumes(const TetrahedralMesh& mesh);
} // namespace insideout
