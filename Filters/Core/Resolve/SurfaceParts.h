// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/ProgressRange.h"
#include "Common/Types.h"

#include <optional>
#include <vector>

namespace insideout
{
/** Some facets that lie near each other. */
struct SurfacePart
{
  Id Begin; ///< in SurfaceParts::Facets
  Id End;
  bool IsTerrain; ///< no two meet beyond the corners and edges that they share by id
};

/** A surface in parts: each facet is in one. */
struct SurfaceParts
{
  std::vector<Id> Facets; ///< part by part
  std::vector<SurfacePart> Parts;
};

/**
 * Cut a surface into parts. Where it is smooth, most parts are proved to be terrains, so that their
 * facets need only be compared with those of other parts. Facets of a part have their centers in
 * one cube of a grid, or in a half of it where there are many; face one way, as seen along an axis;
 * and are joined through edges. The facets in no terrain are one part in each cube.
 *
 * @return nothing if, by a sample, too few facets would be in terrains
 *
 * @param[in] facets not degenerate, no two with the same three points
 * @throws Error (Stopped)
 */
std::optional<SurfaceParts> CutIntoParts(const std::vector<Point>& points,
  const std::vector<Triangle>& facets, Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
