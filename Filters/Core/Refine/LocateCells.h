// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/TetrahedralMesh.h"

#include <vector>

namespace insideout
{
/**
 * Locate places in the cells of a mesh, by exact predicates.
 *
 * @param[in,out] cells per place a cell to start from, replaced by the cell that contains the
 * place, or a near one if rounding put the place outside all cells
 * @throws Error Stopped
 */
void LocateCells(const TetrahedralMesh& mesh, const std::vector<Point>& places,
  std::vector<Id>& cells, Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
