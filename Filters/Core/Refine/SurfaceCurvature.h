// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/TetrahedralMesh.h"
#include "Refine/RefinableSurface.h"

#include <vector>

namespace insideout
{
/**
 * The least radius of curvature at each facet, from the angles at its edges and those of its
 * neighbors (normal cycles; Cohen-Steiner and Morvan 2003). Infinite where the surface is flat, up
 * to rounding of coordinates to floats.
 *
 * @param[in] featureAngle in degrees: edges above it are corners of the surface, which do not count
 */
std::vector<double> RadiiOfCurvature(
  const TetrahedralMesh& mesh, const std::vector<FacetOfInput>& facets, double featureAngle);
} // namespace insideout
