// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "Common/Monitor.h"

namespace insideout
{
/**
 * All pairs of triangles that meet in more than the points and edges they share by id: crossing,
 * touching in a point or along a line, overlapping in a plane. Decided with exact predicates.
 *
 * @param[in] points finite coordinates
 * @param[in] facets non-degenerate triangles (three points not on a line, exactly), no two with the
 *            same three points
 * @return pairs (i, j) with i < j, sorted
 * @throws Error (Stopped)
 */
std::vector<std::array<Id, 2>> FindIntersections(
  const std::vector<Point>& points, const std::vector<Triangle>& facets, Monitor& monitor);

/**
 * The same, but only the pairs of facets of different sets.
 * @param[in] setOf one per facet, at least 0
 * @param[in] nearOthers the facets that may meet one of another set (FacetsNearOthers)
 */
std::vector<std::array<Id, 2>> FindIntersectionsBetween(const std::vector<Point>& points,
  const std::vector<Triangle>& facets, const std::vector<Id>& setOf,
  const std::vector<Id>& nearOthers, Monitor& monitor);

/** The same, but only the pairs (i, j) with j at least `firstNew`: those with a new facet. */
std::vector<std::array<Id, 2>> FindIntersections(const std::vector<Point>& points,
  const std::vector<Triangle>& facets, Id firstNew, Monitor& monitor);
} // namespace insideout
