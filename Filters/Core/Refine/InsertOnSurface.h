// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Refine/Cavity.h"
#include "Refine/RefinableSurface.h"
#include "Refine/SizingField.h"
#include "Refine/SurfaceBound.h"

#include <vector>

namespace insideout
{
/** A face of a cell that is a piece of a facet. */
struct PieceOfCell
{
  Id Cell;
  int Face; ///< across from this corner
};

/** An edge of facets, and a cell at that edge. */
struct EdgeOfCell
{
  Edge Ends = { None, None };
  Id Cell = None;
};

/**
 * Insertion of a point on facets that may be split. It replaces the pieces of these facets whose
 * circumcircle contains the point, and the cells whose circumsphere does, as PointInsertion does in
 * the solid. So the pieces of a split facet stay a Delaunay triangulation of it. On a remeshed
 * surface only the pieces at an edge are halved. Rounding puts the point beside its facet: the
 * facet determines which faces are removed, and each new cell has a positive volume, exactly.
 */
class SurfaceInsertion : public SurfaceOperator
{
public:
  using SurfaceOperator::SurfaceOperator;

  /** Find the cavity of the middle of an edge of facets. */
  bool FindOnEdge(const EdgeOfCell& edge);

  /**
   * Find the cavity of a point in the plane of a piece. The search ends at a ridge in between
   * (Ridge).
   */
  bool FindOnFacet(PieceOfCell piece, const Point& place);

  /** The ridge at which the last search ended; its Cell is None if there is none. */
  const EdgeOfCell& Ridge() const { return this->Met; }

  /**
   * A ridge around the cavity whose diametral ball contains the point; its Cell is None if there is
   * none.
   */
  EdgeOfCell Encroached() const;

  /** The squared distance to the nearest corner of the cavity. */
  double SquaredSpacing() const { return this->Hole.SquaredSpacing(); }

  /** The required edge length at the point. */
  double SizeThere(const SizingField& sizes) const
  {
    return sizes.At(this->Hole.Cells().front(), this->Hole.Place);
  }

  /** Insert the point, unless pieces at it would cross others. @return whether it was inserted */
  bool Insert(SizingField& sizes);

private:
  /** An edge around the replaced pieces, in the direction of one of them. */
  struct RimEdge
  {
    Id From;
    Id To;
    PieceOfCell Piece;
  };

  void Start(const Point& place);
  void AddPiece(const PieceOfCell& piece);
  Triangle CornersOf(const PieceOfCell& piece) const;
  Id FacetOf(const PieceOfCell& piece) const
  {
    return this->Mesh.Cell(piece.Cell).Facets[piece.Face];
  }
  bool IsDropped(Id cell, int k) const;
  bool WalkTo(PieceOfCell& piece, const Point& place);
  PieceOfCell Across(PieceOfCell piece, Id u, Id v) const;
  void GrowPieces();
  bool Complete();
  bool DropPieces();
  void CollectRim();
  bool FitsTogether() const;
  bool StaysApart();

  EdgeOfCell Met;
  Edge Halved;             ///< the edge whose midpoint is inserted, if any
  std::size_t Certain = 0; ///< the pieces that contain the point
  std::vector<PieceOfCell> Pieces;
  std::vector<Triangle> Dropped; ///< these, sorted
  Cavity Hole{ this->Mesh };
  std::vector<RimEdge> Rim;
};
} // namespace insideout
