// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/ProgressRange.h"
#include "Common/TetrahedralMesh.h"

#include <vector>

namespace insideout
{
/** The hull with a solid in it, some of whose points may stand in one place several times, and some
 * of whose cells twice. Cells outside are as they were. */
struct PartedSolid
{
  TetrahedralMesh Mesh;
  std::vector<unsigned char> Inside; ///< one per cell, 0 for outside
  std::vector<Id> Places;    ///< per point the hull's point that it is a copy of; the hull's first
  std::vector<Id> Originals; ///< per cell the hull's cell that it is a copy of; the hull's first
};

/**
 * The solid as it is, nothing of it parted.
 *
 * @throws Error InvalidParameter when there is not one label per cell
 */
PartedSolid UnpartedSolid(const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside);

/**
 * Copy points where the solid's cells meet in them, or in edges of theirs, and no faces lead from
 * one to the other around them (PartCells).
 *
 * @param[in] parted one value per point, 0 for those that are to stay one
 * @throws Error Stopped
 */
void PartPoints(PartedSolid& solid, const std::vector<unsigned char>& parted, Monitor& monitor,
  const ProgressRange& progress);
} // namespace insideout
