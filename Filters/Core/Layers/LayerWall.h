// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Buckets.h"
#include "Refine/RefinableSurface.h"

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

/**
 * The points of a wall that have to stay: those on other facets, and where the cells are not
 * connected through faces. One value per point of the mesh.
 */
std::vector<char> HeldPoints(
  const RefinableMesh& mesh, const RefinableSurface& surface, const LayerWall& wall);
} // namespace insideout
