// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "Common/Monitor.h"
#include "Common/ProgressRange.h"

namespace insideout
{
/**
 * Split constraints at the points that belong to no constraint but lie exactly within one, or
 * within an edge of one. All constraints along an edge are split at the same points, so closed
 * chains stay closed. No new crossing arises.
 *
 * Such a point is a corner of collapsed slivers, or of facets that are no longer constraints. It is
 * nevertheless a point of the tetrahedra, and no face or edge of them can pass through it.
 *
 * @return the unchanged constraints in their order, then the pieces of the others, then facets that
 * were not constraints
 * @throws Error Stopped
 */
FacetComplex SplitAtLoosePoints(
  FacetComplex surface, Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
