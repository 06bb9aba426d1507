// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Edge.h"
#include "Common/Types.h"

#include <cstdint>
#include <vector>

namespace insideout
{
/** A tetrahedron of a RefinableMesh. Neighbor k and facet k are across from corner k. */
struct RefinableCell
{
  Tetrahedron Corners;
  std::array<Id, 4> Neighbors; ///< None beyond the boundary
  std::array<Id, 4> Facets;    ///< that the face is a piece of, None where it may be changed
  Id Region;
  Id Parent; ///< a cell of the input near it
};

/** The corners of a face, across from corner k, in an order that is counter-clockwise seen from it.
 */
constexpr Triangle FaceAcross(const Tetrahedron& c, int k)
{
  return k == 0 ? Triangle{ { c[1], c[3], c[2] } }
    : k == 1    ? Triangle{ { c[0], c[2], c[3] } }
    : k == 2    ? Triangle{ { c[0], c[3], c[1] } }
                : Triangle{ { c[0], c[1], c[2] } };
}

/** Where a point may go. */
enum class PointKind : char
{
  Free,    ///< anywhere in the solid
  InFacet, ///< on its facets, which are smooth there
  OnRidge, ///< along the ridge that it is on
  Fixed    ///< nowhere
};

/**
 * The cells around an edge (U, V): cell k has the corners U, V, Points[k], Points[k + 1]. Around an
 * edge of the boundary the points are one more than the cells, else the last cell ends at the first
 * point. An edge with several such fans, where the boundary is not manifold, has a ring for each.
 */
struct RefinableRing
{
  Id U;
  Id V;
  bool IsClosed;
  bool IsLocked; ///< whether a face at the edge, between two cells, is a piece of a facet
  std::vector<Id> Points;
  std::vector<Id> Cells;
  std::array<Id, 2> EndFacets; ///< at the first and the last point, where it is not closed

  bool IsOnFacet() const { return !this->IsClosed || this->IsLocked; }
};

/** A face that is to be a piece of a facet. */
struct FreshFacet
{
  Triangle Corners;
  Id Facet;
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
class RefinableMesh
{
public:
  std::vector<Point> Points;
  std::vector<PointKind> Kinds; ///< per point
  std::vector<double> Sizes;    ///< per point: how long edges there are to be

  /** Of all cells, dead ones too: their ids are below this. */
  Id NumberOfCells() const { return static_cast<Id>(this->Cells.size()); }
  const RefinableCell& Cell(Id cell) const { return this->Cells[cell]; }
  bool IsDead(Id cell) const { return this->Cells[cell].Corners[0] == None; }

  /** One of the cells around a point, None where it is in no cell. */
  Id CellAt(Id point) const { return this->CellOf[point]; }

  /** Whether the face across from corner k is a piece of a facet, and seen from its side of the
   * larger region, which none beyond the boundary is: each piece is from one side. */
  bool HasPiece(Id cell, int k) const
  {
    const RefinableCell& here = this->Cells[cell];
    const Id neighbor = here.Neighbors[k];
    return here.Facets[k] != None &&
      here.Region > (neighbor == None ? None : this->Cells[neighbor].Region);
  }

  int CornerIndex(Id cell, Id point) const;

  /** The index that `cell` has among the neighbors of the cell across its face k. */
  int MirrorIndex(Id cell, int k) const;

  /** The id that AddPoint gives next. */
  Id NextPoint() const { return static_cast<Id>(this->Points.size()); }

  /** A point in no cell yet. */
  Id AddPoint(const Point& place, PointKind kind, double size);

  /** A cell of the input, with its neighbors' ids. */
  void AddCell(const RefinableCell& cell);

  /** Append the cells around a point that can be reached from CellAt through faces at it. */
  void Star(Id point, std::vector<Id>& cells) const;

  /** The cells around an edge of `cell`. */
  void Ring(Id u, Id v, Id cell, RefinableRing& ring) const;

  /**
   * Put `fresh` in place of `old`, which fill the same space of one region, without facets within.
   * Faces between the two sets and the rest keep their facets; inner ones have none.
   */
  void Replace(const std::vector<Id>& old, const std::vector<Tetrahedron>& fresh);

  /** The same of cells of several regions, and where facets get other pieces. */
  void Replace(const CellExchange& exchange);

  /** Make the face across from corner k, a piece of one facet, one of another, on one side. */
  void SetFacet(Id cell, int k, Id facet) { this->Cells[cell].Facets[k] = facet; }

  /** The cells that the last Replace made. */
  const std::vector<Id>& Fresh() const { return this->FreshCells; }

  /** Move a point to a place that sees all walls of its star. */
  void Move(Id point, const Point& place, const std::vector<Triangle>& walls);

  /** When the cells around a point were changed last, in changes of the mesh. */
  Id ChangedAt(Id point) const { return this->Changed[point]; }
  Id NumberOfChanges() const { return this->Changes; }

  /** How often the cell of this id has been replaced. */
  Id Version(Id cell) const { return this->Versions[cell]; }

  /** A mark per cell for one search after the other: cells are unmarked until Mark is called. */
  void StartMarking() const { ++this->Epoch; }
  bool IsMarked(Id cell) const { return this->Marks[cell] == this->Epoch; }
  void Mark(Id cell) const { this->Marks[cell] = this->Epoch; }
  void Unmark(Id cell) const { this->Marks[cell] = 0; }

private:
  /** A face whose other cell is looked for. */
  struct PendingFace
  {
    Triangle Corners;
    Id Cell;
    int Face;
    Id Facet;
    std::uint32_t Epoch;
    bool IsMatched;
  };

  PendingFace& Slot(const Triangle& sorted);
  void StartTable(std::size_t cells);
  std::size_t EnterWalls(const std::vector<Id>& cells, const std::vector<Triangle>& gone);
  void Remove(Id cell);
  Id NewCell(const RefinableCell& content);
  std::size_t Connect(Id cell);
  std::size_t Place(const FreshFacet& facet);

  /** The other corners of a cell with the edge (u, v): (u, v, first, second) is positive. */
  Edge OtherCorners(Id cell, Id u, Id v) const;

  std::vector<RefinableCell> Cells;
  std::vector<Id> Versions;
  std::vector<Id> FreeCells;
  std::vector<Id> FreshCells;
  std::vector<RefinableCell> FreshContents;
  CellExchange Simple; ///< of cells of one region
  std::vector<Id> CellOf;
  std::vector<Id> Changed;
  Id Changes = 0;
  std::vector<PendingFace> Table;
  std::uint32_t TableEpoch = 0;
  mutable std::vector<std::uint32_t> Marks;
  mutable std::uint32_t Epoch = 0;
};
} // namespace insideout
