// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/RecoverSegments.h"

namespace insideout
{
/**
 * Recover facets: their segments first, then the facets between them, each by pulls and flips, then
 * by Steiner points, which are removed or rounded to doubles. Facets with points that cannot be
 * rounded to doubles are given up.
 * @param[in] facets the missing ones, in the order in which they are tried
 * @param[in] since Steiner points with no change around them after this one stay as they are
 * @param[in,out] givenUp gains the facets that were given up
 * @return whether all Steiner points could be rounded; otherwise the mesh is unusable
 */
bool RecoverConstraints(ExactState& state, const std::vector<Id>& facets, SplitFrom from,
  std::int64_t since, std::set<Id>& givenUp);
} // namespace insideout
