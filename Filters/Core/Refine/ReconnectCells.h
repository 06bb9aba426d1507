// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Mesh/RingTriangulation.h"
#include "Refine/RefinableSurface.h"
#include "Refine/SurfaceBound.h"

#include <vector>

namespace insideout
{
/**
 * Local reconnection: an edge is removed with the cells around it, by the best of all
 * triangulations of its ring (Klincsek 1980; Shewchuk 2002, Two Discrete Optimization Algorithms
 * for the Topological Improvement of Tetrahedral Meshes), or a face is replaced by an edge across
 * it. Each changes the mesh only if the worst shape (ShapeOf) improves. An edge of the boundary
 * between two pieces is flipped to the other diagonal, if the surface allows it.
 */
class Reconnection : public SurfaceOperator
{
public:
  using SurfaceOperator::SurfaceOperator;

  bool RemoveEdge(Id u, Id v, Id cell);

  /** The same, if the new cells' shapes are above `wanted`, at least 0, or half as good as the old
   * ones'. */
  bool RemoveEdgeUnlessWorse(Id u, Id v, Id cell, double wanted);
  bool RemoveFace(Id cell, int face);

  /** The first of these that is possible at the six edges and four faces of a cell. */
  bool ImproveCell(Id cell);

private:
  bool MayRemoveEdge() const;
  bool RemoveEdge(double wanted);
  bool HasCellsBehind(Id cell) const;
  bool TurnDiagonal();
  bool ArePositive() const;

  EdgeRing Around;
  RingTriangulation<double> Triangulation;
  std::vector<Tetrahedron> FreshCells;
  CellExchange Exchange;
  std::vector<Id> Star;
  std::vector<SurfacePiece> GonePieces;
  std::vector<SurfacePiece> FreshPieces;
};
} // namespace insideout
