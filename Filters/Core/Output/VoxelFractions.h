// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/ProgressRange.h"
#include "Common/Types.h"

#include <vector>

namespace insideout
{
/**
 * The fraction of each voxel covered by non-overlapping tetrahedra, from 0 to 1 up to rounding: the
 * volume of their intersections over the voxel's. The same for any number of threads.
 *
 * @param[in] cells of either orientation
 * @param[in] sides bounds of a grid's voxels along x, y and z: strictly ascending, at least two
 * each; the volumes of the voxels do not underflow or overflow
 * @return one value per voxel, x fastest, then y
 * @throws Error (Stopped)
 */
std::vector<double> VoxelFractions(const std::vector<Point>& points,
  const std::vector<Tetrahedron>& cells, const std::array<std::vector<double>, 3>& sides,
  Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
