// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "Common/Monitor.h"
#include "Common/ProgressRange.h"

namespace insideout
{
/**
 * Split constraints at the points that no constraint has, where these lie in them: exactly, within
 * a constraint or within an edge of one. All constraints along an edge are split at the same
 * points, so closed chains stay closed. Nothing crosses that did not before.
 *
 * Such a point is a corner of slivers that collapsed, or of facets that are no constraints any
 * more. The tetrahedra have it all the same, and no face or edge of them can pass through it.
 *
 * @return the unchanged constraints in their order, then the pieces of the others, then facets that
 * were no constraints
 * @throws Error Stopped
 */
FacetComplex SplitAtLoosePoints(
  FacetComplex surface, Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
