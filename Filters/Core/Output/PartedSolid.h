// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/ProgressRange.h"
#include "Common/TetrahedralMesh.h"

#include <vector>

namespace insideout
{
/** The hull with a solid in it, with possibly coincident points and duplicated cells. Outside cells
 * are unchanged. */
struct PartedSolid
{
  TetrahedralMesh Mesh;
  std::vector<unsigned char> Inside; ///< one per cell, 0 for outside
  std::vector<Id> Places;    ///< per point the hull's point that it is a copy of; the hull's first
  std::vector<Id> Originals; ///< per cell the hull's cell that it is a copy of; the hull's first
};

/**
 * The solid without any separation.
 *
 * @throws Error InvalidParameter if there is not one label per cell
 */
PartedSolid UnpartedSolid(const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside);

/**
 * Copy points at which the solid's cells meet in the point or an edge only, without being connected
 * through faces around it (PartCells).
 *
 * @param[in] parted one value per point, 0 for points to leave alone
 * @throws Error Stopped
 */
void PartPoints(PartedSolid& solid, const std::vector<unsigned char>& parted, Monitor& monitor,
  const ProgressRange& progress);
} // namespace insideout
