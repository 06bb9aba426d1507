// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/TetrahedralMesh.h"
#include "Refine/RefinableSurface.h"

#include <vector>

namespace insideout
{
/**
 * Remove needles of rounding from a surface that otherwise stays: contract edges shorter than a
 * tolerance (ContractSmallSteps), and flip the longest edges of triangles that are as low.
 *
 * @param[in] facets of the surface, as in FacetsOf
 * @param[in] locked per facet, whether it stays
 * @return the number of contracted and flipped edges
 * @throws Error Stopped
 */
Id MendNeedles(RefinableMesh& mesh, const std::vector<FacetOfInput>& facets,
  const std::vector<char>& locked, double tolerance, Monitor& monitor);

/**
 * The largest relative change of the area of a label, or of a region's volume. Those below 1e-9 of
 * the sum of all are compared with that.
 *
 * @param[in] regions per cell of the mesh before; empty: all are one
 */
double LargestChange(const TetrahedralMesh& before, const std::vector<Id>& regions,
  const RefinableMesh& after, const std::vector<FacetOfInput>& facets);
} // namespace insideout
