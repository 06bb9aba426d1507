// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Error.h"
#include "Common/ParallelLoop.h"
#include "Common/RawVector.h"
#include "Common/SortedTriangle.h"
#include "Mesh/CellMarks.h"
#include "Mesh/IdSet.h"
#include "Mesh/PendingFaces.h"

#include <algorithm>
#include <string>
#include <utility>

namespace insideout
{
/**
 * A tetrahedralization that can be changed: cells with their neighbors and facets, and one
 * operation that all changes consist of, replacing some cells by others. It stores no coordinates.
 *
 * @tparam Policy has a type Content (a cell's additional data) and HasBoundary: whether faces may
 * lack a second cell; if not, the outside of the hull consists of cells, too; and MostCells, the
 * limit of their number
 */
template <class Policy>
class Mesh
{
public:
  using Content = typename Policy::Content;
  using CellType = MeshCell<Content>;

  /** A face of a remaining cell, and its new values from Replace. */
  struct OuterFace
  {
    MeshFace Face;
    Id Neighbor;
    Id Facet;
  };

  /** The state of the mesh when the journal began, for everything that has changed since. */
  struct Journal
  {
    struct OldVertex
    {
      Id Vertex;
      Id Cell;
      std::int64_t Change;
    };
    bool IsKept = false;
    std::vector<std::pair<Id, CellType>> Cells;
    std::vector<OldVertex> Vertices;
    CellMarks HasCell; ///< each is recorded once
    CellMarks HasVertex;
    Id NumberOfCells = 0;
    Id NumberOfVertices = 0;
    std::vector<Id> FreeCells;
    std::int64_t Changes = 0;
  };

  /** Scratch memory and counts for searching and changing a mesh: one per thread. */
  struct Workspace
  {
    CellMarks Marks;
    std::int64_t Changes = 0;   ///< number of changes made
    std::vector<Id> FreeCells;  ///< dead cells, whose ids are reused, last first
    std::vector<Id> FreshCells; ///< cells made by the last Replace
    Journal Past;

    // Scratch memory of Replace.
    IdSet Old;
    PendingFaces Faces;
    std::vector<CellType> Fresh;
    std::vector<OuterFace> Outer;
  };

  /** The number of all cells, including dead ones: a bound of their ids. */
  Id NumberOfCells() const { return static_cast<Id>(this->Cells.size()); }

  /** Valid until the next Replace. */
  const CellType& Cell(Id cell) const { return this->Cells[cell]; }

  /** Whether the cell was replaced; its id may be reused. */
  bool IsDead(Id cell) const { return this->Cells[cell].Corners[0] == None; }
  int CornerIndex(Id cell, Id vertex) const
  {
    return CornerIndexIn(this->Cells[cell].Corners, vertex);
  }
  bool Has(Id cell, Id vertex) const { return this->CornerIndex(cell, vertex) >= 0; }

  /** One of the cells around a vertex, None if it is in no cell. */
  Id CellAt(Id vertex) const { return this->CellOf[vertex]; }
  bool HasVertex(Id vertex) const { return this->CellOf[vertex] != None; }

  /** The index of `cell` among the neighbors of the cell across its face k. */
  int MirrorIndex(Id cell, int k) const;

  /** The corner of the cell across face k that is not on that face. */
  Id Opposite(Id cell, int k) const
  {
    return this->Cells[this->Cells[cell].Neighbors[k]].Corners[this->MirrorIndex(cell, k)];
  }

  /** The corners of a face, counter-clockwise seen from the opposite corner. */
  Triangle FaceCorners(Id cell, int face) const
  {
    return FaceAcross(this->Cells[cell].Corners, face);
  }

  /** Append the cells around a vertex that are reachable from CellAt through faces at the vertex;
   * none if it is in no cell. */
  void Star(Id vertex, std::vector<Id>& cells, CellMarks& marks) const;

  /** The cells around an edge of `cell`. */
  void Ring(Id u, Id v, Id cell, EdgeRing& ring) const;

  /** Call visit(cell, k) for each face k of a cell that has a facet: from both sides. */
  template <class Visitor>
  void VisitFacets(const Visitor& visit) const
  {
    for (Id cell = 0; cell < this->NumberOfCells(); ++cell)
    {
      for (int k = 0; k < 4 && !this->IsDead(cell); ++k)
      {
        if (this->Cells[cell].Facets[k] != None)
        {
          visit(cell, k);
        }
      }
    }
  }

  /** The value of Workspace::Changes after the last change of the cells around a vertex. */
  std::int64_t LastChangeAround(Id vertex) const { return this->ChangeAround[vertex]; }

protected:
  /** Add a vertex in no cell yet. */
  void AppendVertex(std::int64_t changes)
  {
    this->CellOf.push_back(None);
    this->ChangeAround.push_back(changes);
  }

  /** @throws Error TooLarge if `cells` are more than a mesh can have */
  static void CheckNumber(std::size_t cells)
  {
    if (cells > Policy::MostCells)
    {
      throw Error(ErrorCode::TooLarge,
        "a mesh of " + std::to_string(cells) + " cells is larger than the " +
          std::to_string(Policy::MostCells) + " that ids of 32 bits allow");
    }
  }

  /**
   * Set all cells, on several threads.
   * @param[in] cellOf returns the cell of an id, with its neighbors' ids
   * @throws Error TooLarge
   */
  template <class CellOf>
  void SetCells(std::size_t count, const CellOf& cellOf)
  {
    constexpr double NanosecondsPerCell = 50;
    CheckNumber(count);
    this->Cells.resize(count);
    ParallelLoop(this->NumberOfCells(), NanosecondsPerCell,
      [&](Id cell) { this->Cells[cell] = cellOf(cell); });
    for (Id cell = 0; cell < this->NumberOfCells(); ++cell)
    {
      this->EnterAtCorners(cell);
    }
  }

  /** Make a cell the one that CellAt returns for its corners. */
  void EnterAtCorners(Id cell)
  {
    for (const Id corner : this->Cells[cell].Corners)
    {
      this->CellOf[corner] = cell;
    }
  }

  /** The arguments of Replace. */
  struct Replacement
  {
    const std::vector<Id>& Old;
    const std::vector<Tetrahedron>& Fresh;
    const std::vector<Triangle>& Gone; ///< removed pieces of the boundary, sorted
    /// faces of fresh cells, or of cells behind the old ones
    const std::vector<FreshFacet>& Facets;
  };

  /**
   * Replace old cells by fresh ones that fill the same space. Faces between these and the rest keep
   * their facets; inner faces have none, unless given.
   * @param[in] contentOf called with the number of a fresh cell and its id
   * @throws Error Inconsistent, leaving the mesh unchanged, if old cells do not exist or the fresh
   * ones have another boundary; likewise TooLarge
   */
  template <class ContentOf>
  void Replace(const Replacement& exchange, const ContentOf& contentOf, Workspace& work);

  /** Start a journal for restoring the present state; an existing journal is discarded. */
  void StartJournal(Workspace& work) const;

  /** Restore the state at the start of the journal, and end the journal. */
  void GoBack(Workspace& work);

  /** Record a cell before it changes. */
  void Record(Id cell, Workspace& work) const
  {
    Journal& past = work.Past;
    if (past.IsKept && cell < past.NumberOfCells && !past.HasCell.Has(cell))
    {
      past.HasCell.Add(cell);
      past.Cells.emplace_back(cell, this->Cells[cell]);
    }
  }

  /** Record a vertex before it changes. */
  void RecordVertex(Id vertex, Workspace& work) const
  {
    Journal& past = work.Past;
    if (past.IsKept && vertex < past.NumberOfVertices && !past.HasVertex.Has(vertex))
    {
      past.HasVertex.Add(vertex);
      past.Vertices.push_back({ vertex, this->CellOf[vertex], this->ChangeAround[vertex] });
    }
  }

  RawVector<CellType> Cells;
  std::vector<Id> CellOf;                 ///< per vertex, None for none
  std::vector<std::int64_t> ChangeAround; ///< per vertex

private:
  void MarkOld(const std::vector<Id>& old, Workspace& work) const;
  std::size_t EnterWalls(const Replacement& exchange, Workspace& work) const;
  void NumberFresh(const Replacement& exchange, Workspace& work) const;
  bool Match(Id number, int k, Workspace& work) const;
  bool Place(const FreshFacet& facet, Workspace& work) const;
  void RecordAll(const Replacement& exchange, Workspace& work) const;
  void Commit(const Replacement& exchange, Workspace& work);
};

// --- Queries -------------------------------------------------------------------------------------

template <class Policy>
int Mesh<Policy>::MirrorIndex(Id cell, int k) const
{
  // Two cells may share several faces; each is opposite to a corner of its own.
  const CellType& other = this->Cells[this->Cells[cell].Neighbors[k]];
  const Tetrahedron& t = this->Cells[cell].Corners;
  for (int j = 0; j < 4; ++j)
  {
    const Id apex = other.Corners[j];
    if (other.Neighbors[j] == cell && apex != t[(k + 1) % 4] && apex != t[(k + 2) % 4] &&
      apex != t[(k + 3) % 4])
    {
      return j;
    }
  }
  return -1;
}

template <class Policy>
void Mesh<Policy>::Star(Id vertex, std::vector<Id>& cells, CellMarks& marks) const
{
  const Id first = this->CellOf[vertex];
  if (first == None)
  {
    return;
  }
  std::size_t next = cells.size();
  marks.Start(this->NumberOfCells());
  marks.Add(first);
  cells.push_back(first);
  for (; next < cells.size(); ++next)
  {
    const CellType& cell = this->Cells[cells[next]];
    for (int k = 0; k < 4; ++k)
    {
      if (cell.Corners[k] == vertex)
      {
        continue;
      }
      const Id neighbor = cell.Neighbors[k];
      if ((!Policy::HasBoundary || neighbor != None) && !marks.Has(neighbor))
      {
        marks.Add(neighbor);
        cells.push_back(neighbor);
      }
    }
  }
}

template <class Policy>
void Mesh<Policy>::Ring(Id u, Id v, Id cell, EdgeRing& ring) const
{
  const auto others = [&](Id at) -> const std::array<std::int8_t, 2>&
  { return OtherCorners[this->CornerIndex(at, u)][this->CornerIndex(at, v)]; };
  ring.U = u;
  ring.V = v;
  ring.IsClosed = true;
  ring.IsLocked = false;
  ring.Points.clear();
  ring.Cells.clear();
  Id start = cell;
  if constexpr (Policy::HasBoundary)
  {
    // Backward to the boundary, if there is one, then forward.
    Id before = cell;
    do
    {
      start = before;
      before = this->Cells[start].Neighbors[others(start)[1]];
    } while (before != None && before != cell);
    ring.IsClosed = before != None;
    start = ring.IsClosed ? cell : start;
    ring.EndFacets[0] = this->Cells[start].Facets[others(start)[1]];
  }
  Id at = start;
  do
  {
    const auto [first, second] = others(at);
    const CellType& here = this->Cells[at];
    ring.Points.push_back(here.Corners[first]);
    ring.Cells.push_back(at);
    at = here.Neighbors[first];
    if (Policy::HasBoundary && at == None)
    {
      ring.Points.push_back(here.Corners[second]);
      ring.EndFacets[1] = here.Facets[first];
      return;
    }
    ring.IsLocked = ring.IsLocked || here.Facets[first] != None;
  } while (at != start);
}

// --- Changes -------------------------------------------------------------------------------------

template <class Policy>
void Mesh<Policy>::MarkOld(const std::vector<Id>& old, Workspace& work) const
{
  work.Old.Clear();
  for (const Id cell : old)
  {
    if (this->IsDead(cell) || work.Old.Has(cell))
    {
      throw Error(ErrorCode::Inconsistent, "cells were replaced that are not there");
    }
    work.Old.Add(cell);
  }
}

/** Enter the faces between the marked cells and the rest. @return their number */
template <class Policy>
std::size_t Mesh<Policy>::EnterWalls(const Replacement& exchange, Workspace& work) const
{
  std::size_t walls = 0;
  for (const Id cell : exchange.Old)
  {
    const CellType& here = this->Cells[cell];
    for (int k = 0; k < 4; ++k)
    {
      const Id neighbor = here.Neighbors[k];
      const bool isOuter = Policy::HasBoundary && neighbor == None;
      if (!isOuter && work.Old.Has(neighbor))
      {
        continue;
      }
      const Triangle corners = SortedTriangle(FaceAcross(here.Corners, k)).Points;
      if (!isOuter ||
        std::find(exchange.Gone.begin(), exchange.Gone.end(), corners) == exchange.Gone.end())
      {
        work.Faces.Enter(work.Faces.At(corners), corners,
          { neighbor, isOuter ? 0 : this->MirrorIndex(cell, k) }, None, here.Facets[k]);
        ++walls;
      }
    }
  }
  return walls;
}

/** The ids of fresh cells once the old ones are dead. */
template <class Policy>
void Mesh<Policy>::NumberFresh(const Replacement& exchange, Workspace& work) const
{
  work.FreshCells.clear();
  const std::size_t count = exchange.Fresh.size();
  const auto append = [&](const std::vector<Id>& dead)
  {
    const std::size_t some = std::min(dead.size(), count - work.FreshCells.size());
    work.FreshCells.insert(
      work.FreshCells.end(), dead.rbegin(), dead.rbegin() + static_cast<std::ptrdiff_t>(some));
  };
  append(exchange.Old);
  append(work.FreeCells);
  for (Id id = this->NumberOfCells(); work.FreshCells.size() < count; ++id)
  {
    work.FreshCells.push_back(id);
  }
  CheckNumber(
    this->Cells.size() + count - std::min(count, exchange.Old.size() + work.FreeCells.size()));
}

/** Connect face k of a fresh cell with its entry. @return false if it is the first */
template <class Policy>
bool Mesh<Policy>::Match(Id number, int k, Workspace& work) const
{
  CellType& cell = work.Fresh[number];
  const Id id = work.FreshCells[number];
  const Triangle corners = SortedTriangle(FaceAcross(cell.Corners, k)).Points;
  PendingFace& face = work.Faces.At(corners);
  if (!work.Faces.IsTaken(face))
  {
    work.Faces.Enter(face, corners, { id, k }, number, None);
    return false;
  }
  if (face.Other != None)
  {
    throw Error(
      ErrorCode::Inconsistent, "cells were replaced by others of which three share a face");
  }
  face.Other = number;
  face.AtOther = static_cast<std::int8_t>(k);
  cell.Neighbors[k] = face.Cell;
  cell.Facets[k] = face.Facet;
  if (face.Fresh != None)
  {
    work.Fresh[face.Fresh].Neighbors[face.At] = id;
  }
  else if (!Policy::HasBoundary || face.Cell != None)
  {
    work.Outer.push_back({ { face.Cell, face.At }, id, this->Cells[face.Cell].Facets[face.At] });
  }
  return true;
}

/**
 * Make a face of the fresh cells a piece of a facet, or a wall if the cell at it is removed without
 * replacement.
 *
 * @return whether it is on the boundary
 */
template <class Policy>
bool Mesh<Policy>::Place(const FreshFacet& facet, Workspace& work) const
{
  PendingFace& face = work.Faces.At(SortedTriangle(facet.Corners).Points);
  if (!work.Faces.IsTaken(face) || face.Cell == None || face.IsOnBoundary)
  {
    throw Error(ErrorCode::Inconsistent, "a facet was put where no cell has a face");
  }
  face.IsOnBoundary = face.Other == None;
  if (face.Fresh != None)
  {
    work.Fresh[face.Fresh].Facets[face.At] = facet.Facet;
  }
  else
  {
    work.Outer.push_back({ { face.Cell, face.At },
      face.IsOnBoundary ? None : work.FreshCells[face.Other], facet.Facet });
  }
  if (!face.IsOnBoundary)
  {
    work.Fresh[face.Other].Facets[face.AtOther] = facet.Facet;
  }
  return face.IsOnBoundary;
}

template <class Policy>
void Mesh<Policy>::StartJournal(Workspace& work) const
{
  Journal& past = work.Past;
  past.IsKept = true;
  past.Cells.clear();
  past.Vertices.clear();
  past.NumberOfCells = this->NumberOfCells();
  past.NumberOfVertices = static_cast<Id>(this->CellOf.size());
  past.HasCell.Start(past.NumberOfCells);
  past.HasVertex.Start(past.NumberOfVertices);
  past.FreeCells = work.FreeCells;
  past.Changes = work.Changes;
}

template <class Policy>
void Mesh<Policy>::GoBack(Workspace& work)
{
  Journal& past = work.Past;
  for (const auto& [id, cell] : past.Cells)
  {
    this->Cells[id] = cell;
  }
  for (const auto& [vertex, cell, change] : past.Vertices)
  {
    this->CellOf[vertex] = cell;
    this->ChangeAround[vertex] = change;
  }
  this->Cells.resize(static_cast<std::size_t>(past.NumberOfCells));
  this->CellOf.resize(static_cast<std::size_t>(past.NumberOfVertices));
  this->ChangeAround.resize(static_cast<std::size_t>(past.NumberOfVertices));
  work.FreeCells = past.FreeCells;
  work.Changes = past.Changes;
  past.IsKept = false;
}

/** Record the cells and vertices that Commit changes. */
template <class Policy>
void Mesh<Policy>::RecordAll(const Replacement& exchange, Workspace& work) const
{
  for (const Id cell : exchange.Old)
  {
    this->Record(cell, work);
  }
  for (std::size_t i = exchange.Old.size(); i < work.FreshCells.size(); ++i)
  {
    this->Record(work.FreshCells[i], work);
  }
  for (const OuterFace& outer : work.Outer)
  {
    this->Record(outer.Face.Cell, work);
  }
  const auto recordCorners = [&](const auto& corners)
  {
    for (const Id corner : corners)
    {
      this->RecordVertex(corner, work);
    }
  };
  for (const Id cell : exchange.Old)
  {
    recordCorners(this->Cells[cell].Corners);
  }
  std::for_each(exchange.Fresh.begin(), exchange.Fresh.end(), recordCorners);
}

/** Make the prepared change. Only a lack of memory stops it. */
template <class Policy>
void Mesh<Policy>::Commit(const Replacement& exchange, Workspace& work)
{
  if (work.Past.IsKept)
  {
    this->RecordAll(exchange, work);
  }
  ++work.Changes;
  for (const Id cell : exchange.Old)
  {
    // A vertex left without a cell gets one below, or is no longer in the mesh.
    for (const Id corner : this->Cells[cell].Corners)
    {
      this->CellOf[corner] = None;
    }
    this->Cells[cell].Corners[0] = None;
    work.FreeCells.push_back(cell);
  }
  for (std::size_t i = 0; i < work.Fresh.size(); ++i)
  {
    const Id id = work.FreshCells[i];
    if (work.FreeCells.empty())
    {
      this->Cells.push_back(work.Fresh[i]);
    }
    else
    {
      work.FreeCells.pop_back();
      this->Cells[id] = work.Fresh[i];
    }
    for (const Id corner : work.Fresh[i].Corners)
    {
      this->CellOf[corner] = id;
      this->ChangeAround[corner] = work.Changes;
    }
  }
  for (const auto& [face, neighbor, facet] : work.Outer)
  {
    this->Cells[face.Cell].Neighbors[face.Face] = neighbor;
    this->Cells[face.Cell].Facets[face.Face] = facet;
  }
  for (const FreshFacet& facet : exchange.Facets)
  {
    const PendingFace& face = work.Faces.At(SortedTriangle(facet.Corners).Points);
    for (int k = 0; face.IsOnBoundary && k < 3; ++k)
    {
      this->CellOf[facet.Corners[k]] = face.Cell; // it may be in no fresh cell
    }
  }
}

template <class Policy>
template <class ContentOf>
void Mesh<Policy>::Replace(const Replacement& exchange, const ContentOf& contentOf, Workspace& work)
{
  const std::size_t count = exchange.Fresh.size();
  work.Faces.Start(exchange.Old.size() + count);
  work.Outer.clear();
  work.Fresh.resize(count);
  this->MarkOld(exchange.Old, work);
  std::size_t alone = this->EnterWalls(exchange, work);
  this->NumberFresh(exchange, work);
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::array<Id, 4> none = { { None, None, None, None } };
    work.Fresh[i] = { contentOf(i, work.FreshCells[i]), exchange.Fresh[i], none, none };
    for (int k = 0; k < 4; ++k)
    {
      alone += this->Match(static_cast<Id>(i), k, work) ? -1 : 1;
    }
  }
  for (const FreshFacet& facet : exchange.Facets)
  {
    alone -= this->Place(facet, work) ? 1 : 0;
  }
  if (alone != 0)
  {
    throw Error(ErrorCode::Inconsistent, "cells were replaced by others with another boundary");
  }
  this->Commit(exchange, work);
}
} // namespace insideout
