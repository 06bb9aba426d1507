// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Refine/RefinableSurface.h"
#include "Refine/SurfaceBound.h"

#include <vector>

namespace insideout
{
/**
 * Removes points from a remeshed surface by contracting edges of the surface. The surface has to
 * stay within the tolerance and keep its topology (the link conditions of Dey, Edelsbrunner, Guha
 * and Nekhayev 1999, Topology Preserving Edge Contraction).
 */
class SurfaceContraction : public SurfaceOperator
{
public:
  using SurfaceOperator::SurfaceOperator;

  /**
   * Contract a point into a neighbor, if all new shapes (ShapeOf) are above `wanted`, at least 0,
   * and no edge gets longer than `longest` times the sizes at its ends.
   */
  bool Contract(Id point, Id target, double wanted, double longest);

  /**
   * Contract a point with all its ridges into a neighbor, which then has to stay. All new cells
   * must have a shape above `wanted`, each piece must keep its orientation, and no label may lose
   * its last piece.
   */
  bool ContractStep(Id point, Id target, double wanted);

  /** Contract a point into the first of its neighbors for which this is possible. */
  bool Remove(Id point, double wanted, double longest);

private:
  /** The surroundings of a point. */
  struct Around
  {
    std::vector<Id> Cells;
    std::vector<Id> Points;
    std::vector<Edge> Edges;      ///< opposite faces
    std::vector<Id> FacetPoints;  ///< other ends of edges of facets
    std::vector<Edge> FacetEdges; ///< opposite edges in pieces of facets
  };
  void Look(Id point, Around& around) const;
  bool KeepsTopology(Id point, Id target);
  bool KeepsLengths(Id target, double longest) const;
  bool MakeCells(Id point, Id target, double wanted);
  bool Approach(Id point, Id target, double wanted);
  void MakePieces(Id point, Id target);
  void Replace();

  Around OfPoint;
  Around OfTarget;
  CellExchange Exchange;
  std::vector<SurfacePiece> Gone;
  std::vector<SurfacePiece> Fresh;
  std::vector<SurfacePiece> Moved; ///< for each fresh piece, the gone one that it comes from
};
} // namespace insideout
