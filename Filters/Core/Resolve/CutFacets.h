// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/ParallelLoop.h"
#include "Resolve/PlanarSubdivision.h"

namespace insideout
{
/**
 * Cut facets where they meet: every facet of a pair becomes pieces, which meet the pieces of the
 * others in common points and edges. This is exact: one point may have two names in different
 * subdivisions; both are then rounded to the same doubles.
 *
 * @param[in] pairs the result of FindIntersections, or a part of it
 * @return one subdivision for every group of facets that overlap in a plane (mostly single facets),
 * by lowest facet; sources are facet ids. Facets in no pair have none.
 * @throws Error (Stopped)
 */
std::vector<PlanarSubdivision> CutFacets(const FacetList& surface,
  const std::vector<std::array<Id, 2>>& pairs, Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
