// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/FlippableMesh.h"

#include <vector>

namespace insideout
{
/**
 * Divide the vertices of a mesh into 2^levels blocks by planes across the longest axes, each of
 * which halves a sample. The points alone decide.
 * @return per vertex the number of its block, None for the infinite vertex; numbers without their
 * last digit are those of blocks twice as large
 */
std::vector<Id> BlocksOfVertices(const FlippableMesh& mesh, int levels);
} // namespace insideout
