// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Refine/RefinableSurface.h"
#include "Refine/SizingField.h"
#include "Refine/SurfaceBound.h"

namespace insideout
{
/**
 * Make the worst cells better, the worst first, each by the first of these that does: other cells
 * between the same points (Reconnection), another place for a corner (PointSmoothing), a corner
 * less (Contraction), a point more (PointInsertion). No step makes the worst shape of the cells it
 * changes worse, so that it ends.
 *
 * @param[in] since of the mesh's changes (NumberOfChanges): cells around which nothing has changed
 *   since then are left; None: all are looked at
 * @param[in] passes over all cells, of which the first adds no points
 * @throws Error Stopped
 */
void ImproveCells(RefinableMesh& mesh, RefinableSurface& surface, SurfaceBound& bound,
  SizingField& sizes, Monitor& monitor, const ProgressRange& progress, std::int64_t since = None,
  int passes = 4);
} // namespace insideout
