// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"

/** References for the algorithms: slow, exact and straight from the definition. */
namespace testmeshes
{
using namespace insideout;

/**
 * Whether two triangles have a point in common that is not in the corner or edge that they share by
 * id. Clips one with the other in rational numbers.
 */
bool MeetBeyondSharedByClipping(
  const std::vector<Point>& points, const Triangle& a, const Triangle& b);

/** All such pairs (i, j), i < j, sorted. */
std::vector<std::array<Id, 2>> IntersectionsByClipping(
  const std::vector<Point>& points, const std::vector<Triangle>& facets);

/** Whether a point lies in a triangle or on an edge of it, but at none of its corners. */
bool LiesWithinByClipping(const std::vector<Point>& points, const Triangle& t, Id point);

/**
 * The first two questions for large surfaces, on all threads: boxes by CGAL's sweep, then signs of
 * exact orientation predicates, and of triangles that share no corner CGAL's do_intersect. The
 * triangles must not be degenerate.
 * @{
 */
bool MeetBeyondSharedByOrientation(
  const std::vector<Point>& points, const Triangle& a, const Triangle& b);
std::vector<std::array<Id, 2>> IntersectionsBySweep(
  const std::vector<Point>& points, const std::vector<Triangle>& facets);
/** @} */
} // namespace testmeshes
