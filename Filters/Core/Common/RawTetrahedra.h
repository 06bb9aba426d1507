// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <vector>

namespace insideout
{
/** The output of any tetrahedralizer. Ids are in range; nothing else is guaranteed. */
struct RawTetrahedra
{
  std::vector<Point> Points; ///< the given ones, bit for bit, then Steiner points
  std::vector<Tetrahedron> Cells;
  std::vector<Triangle> Faces;  ///< faces of cells that are pieces of facets
  std::vector<Id> FacetOfFaces; ///< one per face
};
} // namespace insideout
