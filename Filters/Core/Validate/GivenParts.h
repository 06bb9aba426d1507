// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "Validate/FacetEdges.h"

namespace insideout
{
/**
 * The parts of a surface that was put together of several.
 *
 * Parts are closed by themselves. They are the runs of triangles, in the order given, that are so
 * and do not cancel; where that tells nothing apart, what shares points as given, before points are
 * merged.
 *
 * @param[in] edges those of surface.Facets
 * @return one per source of the facets: equal for triangles of one part, None for those of none
 */
std::vector<Id> FindGivenParts(
  const TriangleSoup& soup, const FacetComplex& surface, const std::vector<FacetEdge>& edges);
} // namespace insideout
