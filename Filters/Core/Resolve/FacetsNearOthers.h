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
} // namespace insideout
