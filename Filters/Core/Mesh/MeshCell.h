// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace insideout
{
/** The limit of a mesh's cells: faces are numbered, as 4 * cell + face, in Ids. */
constexpr std::size_t MostNumberedCells = std::size_t(1) << 29;

/** A tetrahedron of a Mesh. Neighbor k and facet k are opposite to corner k. */
template <class Content>
struct MeshCell : Content
{
  Tetrahedron Corners;         ///< the first is None if the cell is dead
  std::array<Id, 4> Neighbors; ///< None outside the boundary
  std::array<Id, 4> Facets;    ///< facets of the faces, None for none
};

/** The face of a cell opposite to its corner Face. */
struct MeshFace
{
  Id Cell;
  int Face;
};

/** A face, and the facet that it becomes a piece of. */
struct FreshFacet
{
  Triangle Corners;
  Id Facet;
};

/**
 * The cells around an edge (U, V): cell k has the corners U, V, Points[k], Points[k + 1]. Around an
 * edge of the boundary there is one point more than cells; otherwise the last cell ends at the
 * first point. A non-manifold edge of the boundary has one ring per fan.
 */
struct EdgeRing
{
  Id U;
  Id V;
  bool IsClosed = false;
  bool IsLocked = false; ///< whether a face between two cells at the edge is a piece of a facet
  std::vector<Id> Points;
  std::vector<Id> Cells;
  std::array<Id, 2> EndFacets; ///< at the first and the last point, if open

  bool IsOnFacet() const { return !this->IsClosed || this->IsLocked; }
};

/** The other two corners of a cell, so that (i, j, first, second) is an even permutation. */
constexpr std::array<std::array<std::array<std::int8_t, 2>, 4>, 4> OtherCorners = { {
  { { { { 0, 0 } }, { { 2, 3 } }, { { 3, 1 } }, { { 1, 2 } } } },
  { { { { 3, 2 } }, { { 0, 0 } }, { { 0, 3 } }, { { 2, 0 } } } },
  { { { { 1, 3 } }, { { 3, 0 } }, { { 0, 0 } }, { { 0, 1 } } } },
  { { { { 2, 1 } }, { { 0, 2 } }, { { 1, 0 } }, { { 0, 0 } } } },
} };

/** Corners of the face opposite to corner k, counter-clockwise seen from corner k. */
constexpr std::array<std::array<std::int8_t, 3>, 4> FaceSeenFrom = { { { { 1, 3, 2 } },
  { { 0, 2, 3 } }, { { 0, 3, 1 } }, { { 0, 1, 2 } } } };

/** The face opposite to corner k, counter-clockwise seen from it. */
constexpr Triangle FaceAcross(const Tetrahedron& cell, int k)
{
  const auto& f = FaceSeenFrom[k];
  return { { cell[f[0]], cell[f[1]], cell[f[2]] } };
}

/** The index of a vertex among the corners, -1 if it is none of them. */
constexpr int CornerIndexIn(const Tetrahedron& cell, Id vertex)
{
  return cell[0] == vertex ? 0
    : cell[1] == vertex    ? 1
    : cell[2] == vertex    ? 2
    : cell[3] == vertex    ? 3
                           : -1;
}
} // namespace insideout
