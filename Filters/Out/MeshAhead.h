// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Hulls of several surfaces in parallel, one thread each: VTK processes the blocks of a
 * composite data set one by one, and finds their hulls ready.
 */
#pragma once

#include "HullMesh.h"

#include <memory>
#include <vector>

namespace vtkInsideOut
{
struct KeptHull;

/**
 * Mesh hulls that were read. Each result is the same as if made alone; an error of one is its
 * Failure.
 *
 * @param[in] fill whether to make tetrahedra, or to resolve the surfaces only
 * @param[in] threads limit of threads; AllowedThreads is another
 * @param[in,out] monitor gets the total progress, on the calling thread
 * @throws insideout::Error Stopped
 */
void MeshAhead(const std::vector<std::shared_ptr<KeptHull>>& hulls,
  const insideout::HullMeshParameters& parameters, bool fill, int threads,
  insideout::Monitor& monitor);
} // namespace vtkInsideOut
