// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/ProgressRange.h"
#include "WindingNumber/CountedBoundary.h"
#include "WindingNumber/Sites.h"

namespace insideout
{
/** Up to this many sites bars are faster: a tree takes 110 ns per facet, a bar for a site 3 ns. */
constexpr std::size_t MostFewSites = 32;

/**
 * The winding number of a closed chain at each of a few sites, exactly, as by ClosedChainTree, but
 * without a tree. From each site a thin bar leads to beyond the chain, where the winding number is
 * 0. Only triangles that meet the bar are counted; all others are looked at once.
 *
 * @param[in] points below 1 in each coordinate
 * @param[in] triangles not degenerate; their boundary is empty
 * @throws Error Inconsistent, Stopped
 */
std::vector<double> WindingNumbersAtFew(const std::vector<Point>& points,
  const std::vector<CountedTriangle>& triangles, const Sites& sites, Monitor& monitor,
  const ProgressRange& progress);
} // namespace insideout
