// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"

namespace insideout
{
/** The regions behind a triangle and before it, where its normal points: None is the background. */
using Sides = std::array<Id, 2>;

/**
 * Turn triangles over that disagree with their neighbors about the regions on their sides. If
 * exactly two triangles at an edge bound a region, they agree when the region is on matching sides.
 * The majority of each group of agreeing triangles keeps its sides. A group that bounds three
 * regions or more is decided by its outermost region, which its volume identifies.
 *
 * Some programs sort the two labels of a triangle without changing its corners, as some versions of
 * vtkSurfaceNets3D do (VTK issue 19156). The triangles around a region are then oriented
 * inconsistently.
 *
 * @param[in] sides one pair per triangle, of two different regions
 * @return 1 for triangles to be turned over, else 0
 */
std::vector<unsigned char> AgreeOnSides(const TriangleSoup& soup, const std::vector<Sides>& sides);
} // namespace insideout
