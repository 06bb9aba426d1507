// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <vector>

namespace insideout
{
/**
 * The facets that may be near one of another set: all whose boxes, widened by `radius`, meet a box
 * of another set, and some more. A grid instead of a tree makes this cheap if few facets are near.
 *
 * @param[in] points finite
 * @param[in] setOf one per facet; None for facets to be skipped
 * @return ascending
 */
std::vector<Id> FacetsNearOthers(const std::vector<Point>& points,
  const std::vector<Triangle>& facets, const std::vector<Id>& setOf, double radius);

/**
 * The new facets and those that may be near one: all whose boxes meet a new facet's, and some more.
 *
 * @param[in] points finite
 * @param[in] firstNew facets from here on are new
 * @return ascending
 */
std::vector<Id> FacetsNearNew(
  const std::vector<Point>& points, const std::vector<Triangle>& facets, Id firstNew);
} // namespace insideout
