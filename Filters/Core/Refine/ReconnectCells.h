// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Refine/RefinableMesh.h"

#include <vector>

namespace insideout
{
/**
 * Other cells between the same points: an edge removed with the cells around it, by the best of all
 * triangulations of its ring (Klincsek 1980; Shewchuk 2002, Two Discrete Optimization Algorithms
 * for the Topological Improvement of Tetrahedral Meshes), or a face removed for an edge across it.
 * Each does so only where the worst shape (ShapeOf) gets better, and leaves the mesh as it is else.
 */
class Reconnection
{
public:
  explicit Reconnection(RefinableMesh& mesh)
    : Mesh(mesh)
  {
  }

  bool RemoveEdge(Id u, Id v, Id cell);
  bool RemoveFace(Id cell, int face);

  /** The first of these that can be done at the six edges and four faces of a cell. */
  bool ImproveCell(Id cell);

private:
  double ShapeOfTriangle(int i, int j, int k) const;
  void CollectTriangles(int i, int j);
  bool ArePositive() const;

  RefinableMesh& Mesh;
  RefinableRing Around;
  std::vector<double> Best; ///< of part i to j of the ring, the worst shape of its best cells
  std::vector<int> Middle;
  std::vector<Tetrahedron> FreshCells;
};
} // namespace insideout
