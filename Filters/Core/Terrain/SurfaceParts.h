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
  bool IsTerrain; ///< no two facets meet beyond the corners and edges that they share by id
};

/** A partition of a surface's facets into parts. */
struct SurfaceParts
{
  std::vector<Id> Facets; ///< part by part
  std::vector<SurfacePart> Parts;
};

/**
 * Cut a surface into parts. Where it is smooth, most parts are proved to be terrains: their facets
 * need comparing only with those of other parts. Facets of a part are connected through edges, face
 * one way, as seen along an axis, and have their centers in one cube of a grid. In a full cube the
 * part is a half of it, repeatedly. The remaining facets of each cube form one part.
 *
 * @return nothing if a sample shows that too few facets would be in terrains
 *
 * @param[in] facets not degenerate, no two with the same three points
 * @throws Error (Stopped)
 */
std::optional<SurfaceParts> CutIntoParts(const std::vector<Point>& points,
  const std::vector<Triangle>& facets, Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
