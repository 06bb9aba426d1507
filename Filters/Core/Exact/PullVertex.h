// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/ExactState.h"
#include "Exact/MeshReader.h"

#include <cstddef>
#include <limits>

namespace insideout
{
/**
 * Connect a vertex with another. The cells that the segment between them crosses give way to a cone
 * from the vertex over the boundary of their union. Cells behind faces that do not see the vertex
 * belong to that union. Vertices, facets, segments and the hull stay; coplanar faces of the hull
 * may be triangulated another way.
 *
 * Points of CAD models are (nearly) cospherical: more than one mesh is (nearly) Delaunay. This
 * chooses the one that facets need: the pulling triangulation (Lee 1991).
 * @param[in] mostCells limit of the cells that give way
 * @return whether the two are connected; else a constraint is in the way, and the mesh stays as it
 * is
 */
bool PullVertex(ExactState& state, Id apex, Id other,
  std::size_t mostCells = std::numeric_limits<std::size_t>::max());

enum class Pull
{
  Made,
  Obstructed, ///< by a constraint
  Beyond      ///< the cone has cells that the reader does not hold
};

/**
 * Find the cone that PullVertex puts in place. The mesh stays as it is.
 * @param[out] ring scratch
 * @param[out] cone complete if the result is Made
 */
Pull MakePull(const MeshReader& mesh, const SegmentTable& segments, Id apex, Id other,
  std::size_t mostCells, EdgeRing& ring, Cone& cone);
} // namespace insideout
