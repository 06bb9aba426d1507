// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Edge.h"
#include "Mesh/Mesh.h"

namespace insideout
{
/** The policy of a Mesh of a solid: faces on its boundary have one cell. */
struct SolidPolicy
{
  struct Content
  {
    Id Region;
    Id Parent;  ///< a cell of the input near it
    Id Version; ///< how often a cell of this id has been replaced
  };
  static constexpr bool HasBoundary = true;
};

using RefinableCell = MeshCell<SolidPolicy::Content>;

/** Where a point may go. */
enum class PointKind : char
{
  Free,    ///< anywhere in the solid
  InFacet, ///< on its facets, which are smooth there
  OnRidge, ///< along the ridge that it is on
  Fixed    ///< nowhere
};

/** Cells to be, and those that they are put in place of; both fill the same space. */
struct CellExchange
{
  std::vector<Id> Old;
  std::vector<Tetrahedron> Fresh;
  std::vector<Id> Models; ///< per fresh cell the old one that it is in the region of

  std::vector<Triangle> Gone;     ///< pieces of facets around the old cells that go, sorted
  std::vector<FreshFacet> Facets; ///< in place of those

  void Clear();
  void Add(const Tetrahedron& fresh, Id model);
};

/**
 * Tetrahedra of a solid that can be changed by "replace these cells by those". Every cell has a
 * positive volume, exactly, before and after.
 */
class RefinableMesh : public Mesh<SolidPolicy>
{
public:
  std::vector<Point> Points;
  std::vector<PointKind> Kinds; ///< per point
  std::vector<double> Sizes;    ///< per point: how long edges there are to be

  /** Whether the face across from corner k is a piece of a facet, and seen from its side of the
   * larger region, which none beyond the boundary is: each piece is from one side. */
  bool HasPiece(Id cell, int k) const
  {
    const RefinableCell& here = this->Cells[cell];
    const Id neighbor = here.Neighbors[k];
    return here.Facets[k] != None &&
      here.Region > (neighbor == None ? None : this->Cells[neighbor].Region);
  }

  /** The id that AddPoint gives next. */
  Id NextPoint() const { return static_cast<Id>(this->Points.size()); }

  /** A point in no cell yet. */
  Id AddPoint(const Point& place, PointKind kind, double size);

  /** A cell of the input, with its neighbors' ids. */
  void AddCell(const RefinableCell& cell) { this->AppendCell(cell); }

  using Mesh::Star;
  void Star(Id point, std::vector<Id>& cells) const { Mesh::Star(point, cells, this->Own.Marks); }

  /** The cells around a point, and their faces across from it, counter-clockwise seen from it. */
  void StarWithWalls(Id point, std::vector<Id>& cells, std::vector<Triangle>& walls) const;

  /** Mesh::Replace of cells of one region, without facets within. */
  void Replace(const std::vector<Id>& old, const std::vector<Tetrahedron>& fresh);

  /** The same of cells of several regions, and where facets get other pieces. */
  void Replace(const CellExchange& exchange);

  /** Make the face across from corner k, a piece of one facet, one of another, on one side. */
  void SetFacet(Id cell, int k, Id facet) { this->Cells[cell].Facets[k] = facet; }

  /** The cells that the last Replace made. */
  const std::vector<Id>& Fresh() const { return this->Own.FreshCells; }

  /** Move a point to a place that sees all walls of its star. */
  void Move(Id point, const Point& place, const std::vector<Triangle>& walls);

  std::int64_t NumberOfChanges() const { return this->Own.Changes; }

  /** Marks for searches that have none of their own. */
  CellMarks& Marks() const { return this->Own.Marks; }

private:
  template <class ModelOf>
  void Replace(const Replacement& replacement, const ModelOf& modelOf);

  mutable Workspace Own;
};
} // namespace insideout
