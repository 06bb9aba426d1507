// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Refine/RefinableSurface.h"
#include "Refine/SizingField.h"
#include "Refine/SurfaceBound.h"

namespace insideout
{
/**
 * Improve the worst cells, the worst first, each by the first operation that succeeds: reconnecting
 * its points (Reconnection), moving a corner (PointSmoothing), contracting a corner (Contraction),
 * inserting a point (PointInsertion). No step lowers the worst shape of the cells it changes, so
 * improvement terminates.
 *
 * @param[in] since a count of the mesh's changes (NumberOfChanges): cells with no later change
 * around them are skipped; None: no cell is
 * @param[in] passes over all cells; the first adds no points
 *
 * @throws Error Stopped
 */
void ImproveCells(RefinableMesh& mesh, RefinableSurface& surface, SurfaceBound& bound,
  SizingField& sizes, Monitor& monitor, const ProgressRange& progress, std::int64_t since = None,
  int passes = 4);
} // namespace insideout
