// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"

namespace insideout
{
/** The regions behind a triangle and before it, where its normal points: None is the background. */
using Sides = std::array<Id, 2>;

/**
 * Turn triangles over that disagree with their neighbors about what is on which side. Exactly two
 * triangles at an edge that bound a region have it on matching sides. The majority of triangles
 * that agree so keep their sides. A group that bounds three regions or more is decided by the
 * region around all others, which its volume identifies.
 *
 * Some programs sort the two labels of a triangle and leave its corners as they are, as versions of
 * vtkSurfaceNets3D do (VTK issue 19156). The triangles around a region then run both ways.
 *
 * @param[in] sides one pair per triangle, of two different regions
 * @return 1 for triangles to be turned over, else 0
 */
std::vector<unsigned char> AgreeOnSides(const TriangleSoup& soup, const std::vector<Sides>& sides);
} // namespace insideout
