// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/ProgressRange.h"
#include "Refine/RefinableMesh.h"

#include <array>
#include <vector>

namespace insideout
{
/** A part of a facet, halfway to the one that faces it. */
struct WallPart
{
  std::array<Point, 3> Middle;
  double Thickness; ///< of the wall, or of a region between two others
};

/**
 * The walls of a solid and of its regions: for parts of each facet, no larger than the wall is
 * thick, the way straight to a facet that faces it; of many small parts that are near each other
 * the thinnest. Facets that share a point, as at the tip of a
 * wedge, make no wall.
 *
 * @throws Error Stopped
 */
std::vector<WallPart> WallsOf(
  const RefinableMesh& mesh, Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
