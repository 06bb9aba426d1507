// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"

namespace insideout
{
/** What lies behind a triangle and before it, where its normal points: None is the background. */
using Sides = std::array<Id, 2>;

/**
 * Turn triangles over that disagree with their neighbors about what is on which side. Where
 * exactly two triangles at an edge bound a region, that region is on the matching side of both. Of
 * triangles that agree so, most keep their sides. Where they bound three regions or more, the one
 * outside is known by its volume, and decides instead.
 *
 * Some programs sort the two labels of a triangle and leave its corners as they are:
 * vtkSurfaceNets3D does before VTK 9.6. The triangles around a region then run both ways.
 *
 * @param[in] sides one pair per triangle, of two different regions
 * @return 1 for triangles to be turned over, else 0
 */
std::vector<unsigned char> AgreeOnSides(const TriangleSoup& soup, const std::vector<Sides>& sides);
} // namespace insideout
