// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "GraphCutSegmentation.h"
#include "TetrahedralMesh.h"

namespace insideout
{
/** The faces between two cells of the mesh, each once, with their areas: the cut's smoothness term.
 */
std::vector<InteriorFace> InteriorFaces(const TetrahedralMesh& mesh);
} // namespace insideout
