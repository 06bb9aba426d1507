// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Refine/RefinableSurface.h"
#include "Refine/SurfaceBound.h"

#include <vector>

namespace insideout
{
/**
 * Remove needles of rounding from a surface that otherwise stays: contract edges shorter than a
 * tolerance (ContractSmallSteps), and flip the longest edges of triangles that are as low.
 *
 * @param[in] facets of the surface, as in FacetsOf
 * @param[in] locked per facet, whether it stays
 * @param[in] bound of a remeshed surface
 * @return the number of contracted and flipped edges
 * @throws Error Stopped
 */
Id MendNeedles(RefinableMesh& mesh, const std::vector<FacetOfInput>& facets,
  const std::vector<char>& locked, SurfaceBound& bound, double tolerance, Monitor& monitor);
} // namespace insideout
