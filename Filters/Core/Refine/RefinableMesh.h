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
    Id Parent;  ///< a cell of the input near this cell
    Id Version; ///< number of times that a cell of this id has been replaced
  };
  static constexpr bool HasBoundary = true;
  static constexpr std::size_t MostCells = MostNumberedCells;
};

using RefinableCell = MeshCell<SolidPolicy::Content>;

/** The freedom of a point. */
enum class PointKind : char
{
  Free,    ///< anywhere in the solid
  InFacet, ///< on its facets, which are smooth there
  OnRidge, ///< along the ridge that it is on
  Fixed    ///< nowhere
};

/** New cells, and those that they replace; both fill the same space. */
struct CellExchange
{
  std::vector<Id> Old;
  std::vector<Tetrahedron> Fresh;
  std::vector<Id> Models; ///< per fresh cell, the old one whose region it inherits

  std::vector<Triangle> Gone;     ///< pieces of facets of the old cells that are removed, sorted
  std::vector<FreshFacet> Facets; ///< that replace those

  void Clear();
  void Add(const Tetrahedron& fresh, Id model);
};

/**
 * Tetrahedra of a solid, changed by replacing some cells by others. Every cell has a positive
 * volume, exactly, before and after.
 */
class RefinableMesh : public Mesh<SolidPolicy>
{
public:
  std::vector<Point> Points;
  std::vector<PointKind> Kinds; ///< per point
  std::vector<double> Sizes;    ///< per point: the required edge length there

  /** Whether the face opposite to corner k is a piece of a facet, and seen from the side of the
   * larger region. There is no region outside, so each piece is seen from exactly one side. */
  bool HasPiece(Id cell, int k) const
  {
    const RefinableCell& here = this->Cells[cell];
    const Id neighbor = here.Neighbors[k];
    return here.Facets[k] != None &&
      here.Region > (neighbor == None ? None : this->Cells[neighbor].Region);
  }

  /** The id that AddPoint returns next. */
  Id NextPoint() const { return static_cast<Id>(this->Points.size()); }

  /** Add a point in no cell yet. */
  Id AddPoint(const Point& place, PointKind kind, double size);

  /** The cells of the input. */
  using Mesh::SetCells;

  /** The same in place of all cells that there are; the points stay. */
  template <class CellOf>
  void SetAllCells(std::size_t count, const CellOf& cellOf)
  {
    this->CellOf.assign(this->CellOf.size(), None);
    ++this->Own.Changes;
    this->ChangeAround.assign(this->ChangeAround.size(), this->Own.Changes);
    this->Own.FreeCells.clear();
    this->SetCells(count, cellOf);
  }

  using Mesh::Star;
  void Star(Id point, std::vector<Id>& cells) const { Mesh::Star(point, cells, this->Own.Marks); }

  /** The cells around a point, and their opposite faces, counter-clockwise seen from it. */
  void StarWithWalls(Id point, std::vector<Id>& cells, std::vector<Triangle>& walls) const;

  /** Set the cell from which a pinched point's star is found, after its cell was removed. */
  void SetCellAt(Id point, Id cell) { this->CellOf[point] = cell; }

  /** Mesh::Replace for cells of one region, without facets within. */
  void Replace(const std::vector<Id>& old, const std::vector<Tetrahedron>& fresh);

  /** The same for cells of several regions, and with new pieces of facets. */
  void Replace(const CellExchange& exchange);

  /**
   * Reassign the face opposite to corner k, a piece of one facet, to another facet, on one side.
   */
  void SetFacet(Id cell, int k, Id facet) { this->Cells[cell].Facets[k] = facet; }

  /** The cells that the last Replace made. */
  const std::vector<Id>& Fresh() const { return this->Own.FreshCells; }

  /** Move a point to a place from which all walls of its star are visible. */
  void Move(Id point, const Point& place, const std::vector<Triangle>& walls);

  std::int64_t NumberOfChanges() const { return this->Own.Changes; }

  /** Marks for searches without marks of their own. */
  CellMarks& Marks() const { return this->Own.Marks; }

private:
  template <class ModelOf>
  void Replace(const Replacement& replacement, const ModelOf& modelOf);

  mutable Workspace Own;
};
} // namespace insideout
