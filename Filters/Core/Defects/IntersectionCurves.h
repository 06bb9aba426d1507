// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/Types.h"

#include <vector>

namespace insideout
{
/** Intersections of facets: segments between points. */
struct IntersectionCurves
{
  std::vector<Point> Points; ///< no two equal; points in no segment are where facets only touch
  std::vector<std::array<Id, 2>> Segments; ///< lower id first; sorted, no two equal
};

/**
 * Intersect facets: a segment or a point for two that cross or touch, the boundary of the overlap
 * for two coplanar ones. Computed exactly, with each coordinate then rounded to the nearest double.
 * A segment whose ends round to one point becomes that point.
 *
 * @param[in] points finite
 * @param[in] facets none degenerate
 * @param[in] pairs facets that meet, from FindIntersections
 * @throws Error (Stopped)
 */
IntersectionCurves TraceIntersections(const std::vector<Point>& points,
  const std::vector<Triangle>& facets, const std::vector<std::array<Id, 2>>& pairs,
  Monitor& monitor);
} // namespace insideout
