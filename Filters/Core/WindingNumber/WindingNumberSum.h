// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "Common/Monitor.h"
#include "Common/ProgressRange.h"
#include "Common/Stages.h"
#include "WindingNumber/Sites.h"

namespace insideout
{
/**
 * The generalized winding number of a complex at each site, as the sum over all facets of
 * multiplicity times solid angle over 4 pi (thesis, chapter 8; the solid angle by van Oosterom and
 * Strackee 1983). The site is not rounded, and its side of each facet is decided exactly, so no
 * value is off by a whole facet. Where it lies on a facet, that facet counts 0, the mean of its two
 * sides.
 *
 * Time is proportional to facets times sites, on all threads. The values depend neither on the
 * number of threads nor on a scaling of all coordinates by a power of two. Reversing all facets
 * negates them.
 *
 * @param[in] surface every facet counts, the ones behind NumberOfConstraints too
 * @param[in] sites finite; their cells may be of any volume, even none
 * @param[in] progress share of the work that these sites are
 * @return one value per site, to about 1e-14 times the root of the number of facets
 * @throws Error (Stopped)
 */
std::vector<double> WindingNumberSum(const FacetComplex& surface, const Sites& sites,
  Monitor& monitor, const ProgressRange& progress = { Stages::WindingNumbers, 0, 1 });
} // namespace insideout
