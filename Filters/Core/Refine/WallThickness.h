// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/ProgressRange.h"
#include "Refine/RefinableMesh.h"

#include <array>
#include <vector>

namespace insideout
{
/** A part of a facet, shifted halfway to the facet that faces it. */
struct WallPart
{
  std::array<Point, 3> Middle;
  double Thickness; ///< of the wall, or of a region between two others
};

/**
 * The walls of a solid and of its regions: for parts of each facet, the straight way to a facet
 * that faces it. Parts are no larger than the wall's thickness, up to some hundred thousand parts
 * in all. A crowd of small parts is replaced by the thinnest of them. Facets that share a point, as
 * at the tip of a wedge, make no wall.
 *
 * @throws Error Stopped
 */
std::vector<WallPart> WallsOf(
  const RefinableMesh& mesh, Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
