// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "Validate/FacetEdges.h"

namespace insideout
{
/**
 * The parts of a surface that was put together of several.
 *
 * Parts are the runs of triangles, in the order given, that are closed by themselves and do not
 * cancel. Where there are no two such runs they are what shares points as given, before points are
 * merged.
 *
 * @param[in] edges those of surface.Facets
 * @return one per source of the facets: equal for triangles of one part
 */
std::vector<Id> FindGivenParts(
  const TriangleSoup& soup, const FacetComplex& surface, const std::vector<FacetEdge>& edges);
} // namespace insideout
