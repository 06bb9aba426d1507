// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Refine/RefinableSurface.h"
#include "Refine/SurfaceBound.h"

#include <vector>

namespace insideout
{
/**
 * Takes points out of a surface that is remeshed, each by moving it along an edge of the surface
 * into the next point. The surface has to stay near enough, and connected as it was (the link
 * conditions of Dey, Edelsbrunner, Guha and Nekhayev 1999, Topology Preserving Edge Contraction).
 */
class SurfaceContraction
{
public:
  SurfaceContraction(RefinableMesh& mesh, RefinableSurface& surface, SurfaceBound& bound)
    : Mesh(mesh)
    , Surface(surface)
    , Bound(bound)
  {
  }

  /**
   * Move a point into a neighbor, if all new shapes (ShapeOf) are above `wanted`, at least
   * 0, and no edge gets longer than `longest` times the sizes at its ends.
   */
  bool Contract(Id point, Id target, double wanted, double longest);

  /**
   * Move a point with all its ridges into a neighbor, which has to stay then: if all new cells
   * have a shape above `wanted`, each piece looks where it did, and no label loses its last piece.
   */
  bool ContractStep(Id point, Id target, double wanted);

  /** Move a point into the first of its neighbors where that can be done. */
  bool Remove(Id point, double wanted, double longest);

private:
  /** The surroundings of a point. */
  struct Around
  {
    std::vector<Id> Cells;
    std::vector<Id> Points;
    std::vector<Edge> Edges;      ///< across from it in faces
    std::vector<Id> FacetPoints;  ///< at the other ends of edges of facets
    std::vector<Edge> FacetEdges; ///< across from it in pieces of facets
  };
  void Look(Id point, Around& around) const;
  bool KeepsTopology(Id point, Id target);
  bool KeepsLengths(Id target, double longest) const;
  bool MakeCells(Id point, Id target, double wanted);
  bool Approach(Id point, Id target, double wanted);
  void MakePieces(Id point, Id target);
  bool KeepsLabels() const;
  void Replace();

  RefinableMesh& Mesh;
  RefinableSurface& Surface;
  SurfaceBound& Bound;
  Around OfPoint;
  Around OfTarget;
  CellExchange Exchange;
  std::vector<SurfacePiece> Gone;
  std::vector<SurfacePiece> Fresh;
  std::vector<SurfacePiece> Moved; ///< those of the gone ones that the fresh ones were
};
} // namespace insideout
