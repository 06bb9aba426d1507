// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <vector>

namespace insideout
{
/** The result of any tetrahedralizer. Ids are in range; what else holds it says. */
struct RawTetrahedra
{
  std::vector<Point> Points; ///< those given, bit by bit, and then Steiner points
  std::vector<Tetrahedron> Cells;
  std::vector<Triangle> Faces;  ///< faces of cells that facets are made of
  std::vector<Id> FacetOfFaces; ///< one per face
};
} // namespace insideout
