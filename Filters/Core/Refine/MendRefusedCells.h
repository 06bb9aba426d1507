// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/ProgressRange.h"
#include "Refine/RefinableSurface.h"
#include "Refine/SurfaceBound.h"

namespace insideout
{
/**
 * Mend cells that a solver refuses (IsRefused) or that are flat (FlatSine), whose shape no other
 * step improves. Inner corners are contracted into neighbors, which makes larger cells. Short edges
 * of the surface are contracted, cells with three faces on the boundary removed. Corners move away
 * from the opposite face, as little as suffices. Flat cells that are stacked near a coordinate
 * plane, where doubles are densest, are stretched together.
 *
 * @param[in] bound of a remeshed surface, if that may change
 * @param[in] distance by which a corner moves at most, and the longest edge that is contracted
 * @param[in] mayChangeSurface whether the surface may change, except for locked facets
 * @return the number of changes of the surface
 * @throws Error Stopped
 */
Id MendRefusedCells(RefinableMesh& mesh, RefinableSurface& surface, SurfaceBound& bound,
  double distance, bool mayChangeSurface, Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
