// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "Validate/FacetEdges.h"

namespace insideout
{
/**
 * Find the closed surfaces that were concatenated to the input.
 *
 * A given surface is a run of triangles, in their order, that is closed by itself and does not
 * cancel. If there are not several runs, it is a closed component of triangles connected through
 * points as given, before merging.
 *
 * @param[in] edges those of surface.Facets
 * @return one per source of the facets: equal for triangles of one surface, None for triangles of
 * no surface
 */
std::vector<Id> FindGivenSurfaces(
  const TriangleSoup& soup, const FacetComplex& surface, const FacetEdges& edges);
} // namespace insideout
