// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <cstdint>
#include <vector>

namespace insideout
{
/** A tetrahedron of a Mesh. Neighbor k and facet k are across from corner k. */
template <class Content>
struct MeshCell : Content
{
  Tetrahedron Corners;         ///< the first is None where the cell is dead
  std::array<Id, 4> Neighbors; ///< None beyond the boundary
  std::array<Id, 4> Facets;    ///< that the face is a piece of, None for none
};

/** The face of a cell across from its corner Face. */
struct MeshFace
{
  Id Cell;
  int Face;
};

/** A face that is to be a piece of a facet. */
struct FreshFacet
{
  Triangle Corners;
  Id Facet;
};

/**
 * The cells around an edge (U, V): cell k has the corners U, V, Points[k], Points[k + 1]. Around an
 * edge of the boundary the points are one more than the cells, else the last cell ends at the first
 * point. An edge with several such fans, where the boundary is not manifold, has a ring for each.
 */
struct EdgeRing
{
  Id U;
  Id V;
  bool IsClosed;
  bool IsLocked; ///< whether a face at the edge, between two cells, is a piece of a facet
  std::vector<Id> Points;
  std::vector<Id> Cells;
  std::array<Id, 2> EndFacets; ///< at the first and the last point, where it is not closed

  bool IsOnFacet() const { return !this->IsClosed || this->IsLocked; }
};

/** The other two corners of a cell, so that (i, j, first, second) is an even permutation. */
constexpr std::array<std::array<std::array<std::int8_t, 2>, 4>, 4> OtherCorners = { {
  { { { { 0, 0 } }, { { 2, 3 } }, { { 3, 1 } }, { { 1, 2 } } } },
  { { { { 3, 2 } }, { { 0, 0 } }, { { 0, 3 } }, { { 2, 0 } } } },
  { { { { 1, 3 } }, { { 3, 0 } }, { { 0, 0 } }, { { 0, 1 } } } },
  { { { { 2, 1 } }, { { 0, 2 } }, { { 1, 0 } }, { { 0, 0 } } } },
} };

/** Corners of the face across from corner k, counter-clockwise seen from corner k. */
constexpr std::array<std::array<std::int8_t, 3>, 4> FaceSeenFrom = { { { { 1, 3, 2 } },
  { { 0, 2, 3 } }, { { 0, 3, 1 } }, { { 0, 1, 2 } } } };

/** The face across from corner k, counter-clockwise seen from it. */
constexpr Triangle FaceAcross(const Tetrahedron& cell, int k)
{
  const auto& f = FaceSeenFrom[k];
  return { { cell[f[0]], cell[f[1]], cell[f[2]] } };
}

/** The place of a vertex among the corners, -1 where it is none of them. */
constexpr int CornerIndexIn(const Tetrahedron& cell, Id vertex)
{
  return cell[0] == vertex ? 0
    : cell[1] == vertex    ? 1
    : cell[2] == vertex    ? 2
    : cell[3] == vertex    ? 3
                           : -1;
}
} // namespace insideout
