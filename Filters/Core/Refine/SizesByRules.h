// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Refine/RefineTetrahedra.h"

#include <vector>

namespace insideout
{
/**
 * The sizing with the lengths that its rules ask for (LengthAt, LengthOfRegion). They grow with
 * distance by Grading, also from the boundary of a region; the least length applies.
 *
 * @param[in] regions one per cell, numbered from 0; empty: all are one
 * @param[in] facets of the mesh
 *
 * @throws Error Stopped
 */
SizingParameters SizesByRules(const TetrahedralMesh& mesh, const std::vector<Id>& regions,
  const std::vector<FacetOfInput>& facets, const RefinementParameters& parameters,
  Monitor& monitor);
} // namespace insideout
