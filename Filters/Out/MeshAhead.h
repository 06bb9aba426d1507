// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * Hulls of several surfaces at once, each by a thread of its own: VTK comes to the blocks of a
 * composite data set one after the other, and finds them made.
 */
#pragma once

#include "HullMesh.h"

#include <memory>
#include <vector>

namespace vtkInsideOut
{
struct KeptHull;

/**
 * Meshes hulls that were read. Each is the same as if it were made alone; what goes wrong with one
 * is its Failure.
 *
 * @param[in] fill whether to make tetrahedra, or to resolve the surfaces only
 * @param[in] threads how many at most; no more than may work
 * @param[in,out] monitor is told on the calling thread which part of them is done
 * @throws insideout::Error Stopped
 */
void MeshAhead(const std::vector<std::shared_ptr<KeptHull>>& hulls,
  const insideout::HullMeshParameters& parameters, bool fill, int threads,
  insideout::Monitor& monitor);
} // namespace vtkInsideOut
