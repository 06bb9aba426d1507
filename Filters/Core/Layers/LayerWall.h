// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Buckets.h"
#include "Common/Types.h"

#include <vector>

namespace insideout
{
/** The triangles of a boundary that get layers, and their points. */
struct LayerWall
{
  /** @param[in] points of the mesh; @param[in] triangles as Triangles has them */
  LayerWall(std::size_t points, std::vector<Triangle> triangles);

  std::vector<Triangle> Triangles; ///< counter-clockwise seen from outside
  std::vector<Id> Points;          ///< of these, ascending
  Buckets<Id> TrianglesAt;         ///< per point of the mesh
  Buckets<Id> NeighborsOf;         ///< per point of the mesh, those that share an edge of the wall
};
} // namespace insideout
