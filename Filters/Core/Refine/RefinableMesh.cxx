// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/RefinableMesh.h"

#include "Common/Error.h"
#include "Common/SortedTriangle.h"

#include <algorithm>

namespace insideout
{
void CellExchange::Clear()
{
  this->Old.clear();
  this->Fresh.clear();
  this->Models.clear();
  this->Gone.clear();
  this->Facets.clear();
}

void CellExchange::Add(const Tetrahedron& fresh, Id model)
{
  this->Fresh.push_back(fresh);
  this->Models.push_back(model);
}

int RefinableMesh::CornerIndex(Id cell, Id point) const
{
  const Tetrahedron& corners = this->Cells[cell].Corners;
  return corners[0] == point ? 0 : corners[1] == point ? 1 : corners[2] == point ? 2 : 3;
}

int RefinableMesh::MirrorIndex(Id cell, int k) const
{
  const std::array<Id, 4>& back = this->Cells[this->Cells[cell].Neighbors[k]].Neighbors;
  return static_cast<int>(std::find(back.begin(), back.end(), cell) - back.begin());
}

Id RefinableMesh::AddPoint(const Point& place, PointKind kind, double size)
{
  this->Points.push_back(place);
  this->Kinds.push_back(kind);
  this->Sizes.push_back(size);
  this->CellOf.push_back(None);
  this->Changed.push_back(0);
  return static_cast<Id>(this->Points.size() - 1);
}

void RefinableMesh::AddCell(const RefinableCell& cell)
{
  const Id id = this->NumberOfCells();
  this->Cells.push_back(cell);
  this->Versions.push_back(0);
  this->Marks.push_back(0);
  for (const Id corner : cell.Corners)
  {
    this->CellOf[corner] = id;
  }
}

void RefinableMesh::Star(Id point, std::vector<Id>& cells) const
{
  this->StartMarking();
  std::size_t next = cells.size();
  cells.push_back(this->CellOf[point]);
  this->Mark(cells.back());
  for (; next < cells.size(); ++next)
  {
    const Id cell = cells[next];
    const RefinableCell& here = this->Cells[cell];
    for (int k = 0; k < 4; ++k)
    {
      const Id neighbor = here.Neighbors[k];
      if (here.Corners[k] != point && neighbor != None && !this->IsMarked(neighbor))
      {
        this->Mark(neighbor);
        cells.push_back(neighbor);
      }
    }
  }
}

Edge RefinableMesh::OtherCorners(Id cell, Id u, Id v) const
{
  // The face across from u, counter-clockwise seen from it, is (v, second, first).
  const Triangle face = FaceAcross(this->Cells[cell].Corners, this->CornerIndex(cell, u));
  const int at = face[0] == v ? 0 : face[1] == v ? 1 : 2;
  return { face[(at + 2) % 3], face[(at + 1) % 3] };
}

void RefinableMesh::Ring(Id u, Id v, Id cell, RefinableRing& ring) const
{
  ring.U = u;
  ring.V = v;
  ring.IsLocked = false;
  ring.Points.clear();
  ring.Cells.clear();
  // Backward to the boundary, if there is one, then forward.
  Id start = cell;
  Id before = cell;
  do
  {
    start = before;
    before =
      this->Cells[start].Neighbors[this->CornerIndex(start, this->OtherCorners(start, u, v)[1])];
  } while (before != None && before != cell);
  ring.IsClosed = before != None;
  start = ring.IsClosed ? cell : start;
  ring.EndFacets[0] =
    this->Cells[start].Facets[this->CornerIndex(start, this->OtherCorners(start, u, v)[1])];
  Id at = start;
  do
  {
    const auto [first, second] = this->OtherCorners(at, u, v);
    ring.Points.push_back(first);
    ring.Cells.push_back(at);
    const RefinableCell& here = this->Cells[at];
    const int across = this->CornerIndex(at, first);
    at = here.Neighbors[across];
    ring.IsLocked = ring.IsLocked || (at != None && here.Facets[across] != None);
    if (at == None)
    {
      ring.Points.push_back(second);
      ring.EndFacets[1] = here.Facets[across];
    }
  } while (at != None && at != start);
}

void RefinableMesh::Move(Id point, const Point& place, const std::vector<Triangle>& walls)
{
  ++this->Changes;
  this->Points[point] = place;
  this->Changed[point] = this->Changes;
  for (const Triangle& wall : walls)
  {
    for (const Id corner : wall)
    {
      this->Changed[corner] = this->Changes;
    }
  }
}

RefinableMesh::PendingFace& RefinableMesh::Slot(const Triangle& sorted)
{
  const std::size_t mask = this->Table.size() - 1;
  std::size_t at = HashOfTriangle()(sorted) & mask;
  while (this->Table[at].Epoch == this->TableEpoch && this->Table[at].Corners != sorted)
  {
    at = (at + 1) & mask;
  }
  return this->Table[at];
}

/** Make room for the faces of so many cells, and forget those that are entered. */
void RefinableMesh::StartTable(std::size_t cells)
{
  std::size_t size = std::max<std::size_t>(this->Table.size(), 64);
  while (size < 6 * cells)
  {
    size *= 2;
  }
  if (size > this->Table.size())
  {
    this->Table.assign(size, { { { None, None, None } }, None, 0, None, 0, false });
    this->TableEpoch = 0;
  }
  ++this->TableEpoch;
}

/** Enter the faces between the marked cells and the rest. @return how many */
std::size_t RefinableMesh::EnterWalls(
  const std::vector<Id>& cells, const std::vector<Triangle>& gone)
{
  std::size_t walls = 0;
  for (const Id cell : cells)
  {
    const RefinableCell& here = this->Cells[cell];
    for (int k = 0; k < 4; ++k)
    {
      const Id neighbor = here.Neighbors[k];
      const bool isInner = neighbor != None && this->IsMarked(neighbor);
      if (isInner)
      {
        continue;
      }
      const Triangle corners = SortedTriangle(FaceAcross(here.Corners, k)).Points;
      if (neighbor != None || std::find(gone.begin(), gone.end(), corners) == gone.end())
      {
        this->Slot(corners) = { corners, neighbor,
          neighbor == None ? 0 : this->MirrorIndex(cell, k), here.Facets[k], this->TableEpoch,
          false };
        ++walls;
      }
    }
  }
  return walls;
}

void RefinableMesh::Remove(Id cell)
{
  // A point that is left without a cell gets one back, or is no longer in the mesh.
  for (const Id corner : this->Cells[cell].Corners)
  {
    this->CellOf[corner] = None;
  }
  this->Cells[cell].Corners[0] = None;
  ++this->Versions[cell];
  this->FreeCells.push_back(cell);
}

Id RefinableMesh::NewCell(const RefinableCell& content)
{
  if (this->FreeCells.empty())
  {
    this->Cells.push_back(content);
    this->Versions.push_back(0);
    this->Marks.push_back(0);
    return this->NumberOfCells() - 1;
  }
  const Id cell = this->FreeCells.back();
  this->FreeCells.pop_back();
  this->Cells[cell] = content;
  this->Marks[cell] = 0;
  return cell;
}

/** Connect a new cell with those behind its faces that are entered, and enter its other faces. */
std::size_t RefinableMesh::Connect(Id cell)
{
  std::size_t matched = 0;
  const Tetrahedron corners = this->Cells[cell].Corners;
  for (int k = 0; k < 4; ++k)
  {
    this->CellOf[corners[k]] = cell;
    this->Changed[corners[k]] = this->Changes;
    const Triangle face = SortedTriangle(FaceAcross(corners, k)).Points;
    PendingFace& pending = this->Slot(face);
    if (pending.Epoch != this->TableEpoch)
    {
      pending = { face, cell, k, None, this->TableEpoch, false };
      continue;
    }
    this->Cells[cell].Neighbors[k] = pending.Cell;
    this->Cells[cell].Facets[k] = pending.Facet;
    if (pending.Cell != None)
    {
      this->Cells[pending.Cell].Neighbors[pending.Face] = cell;
    }
    pending.IsMatched = true;
    ++matched;
  }
  return matched;
}

/**
 * Make a face of the fresh cells a piece of a facet, or a wall, where the cell at it is gone
 * without another. @return 1 where it is on the boundary
 */
std::size_t RefinableMesh::Place(const FreshFacet& facet)
{
  const PendingFace& pending = this->Slot(SortedTriangle(facet.Corners).Points);
  if (pending.Epoch != this->TableEpoch || pending.Cell == None)
  {
    throw Error(ErrorCode::Inconsistent, "a facet was put where no cell has a face");
  }
  RefinableCell& cell = this->Cells[pending.Cell];
  cell.Facets[pending.Face] = facet.Facet;
  if (!pending.IsMatched)
  {
    cell.Neighbors[pending.Face] = None;
    for (const Id corner : facet.Corners)
    {
      this->CellOf[corner] = pending.Cell; // it may be in no fresh cell
    }
    return 1;
  }
  this->Cells[cell.Neighbors[pending.Face]].Facets[this->MirrorIndex(pending.Cell, pending.Face)] =
    facet.Facet;
  return 0;
}

void RefinableMesh::Replace(const std::vector<Id>& old, const std::vector<Tetrahedron>& fresh)
{
  this->Simple.Old = old;
  this->Simple.Fresh = fresh;
  this->Simple.Models.assign(fresh.size(), old.front());
  this->Replace(this->Simple);
}

void RefinableMesh::Replace(const CellExchange& exchange)
{
  this->StartTable(exchange.Old.size() + exchange.Fresh.size());
  ++this->Changes;
  this->StartMarking();
  for (const Id cell : exchange.Old)
  {
    this->Mark(cell);
  }
  const std::size_t walls = this->EnterWalls(exchange.Old, exchange.Gone);
  this->FreshContents.clear();
  for (std::size_t i = 0; i < exchange.Fresh.size(); ++i)
  {
    const std::array<Id, 4> none = { { None, None, None, None } };
    const RefinableCell& model = this->Cells[exchange.Models[i]];
    this->FreshContents.push_back({ exchange.Fresh[i], none, none, model.Region, model.Parent });
  }
  for (const Id cell : exchange.Old)
  {
    this->Remove(cell);
  }
  std::size_t matched = 0;
  this->FreshCells.clear();
  for (const RefinableCell& content : this->FreshContents)
  {
    this->FreshCells.push_back(this->NewCell(content));
    matched += this->Connect(this->FreshCells.back());
  }
  std::size_t onBoundary = 0;
  for (const FreshFacet& facet : exchange.Facets)
  {
    onBoundary += this->Place(facet);
  }
  // Faces of fresh cells are walls, or two that are matched once, or on the boundary; and so are
  // walls that no fresh cell has.
  if (2 * matched + onBoundary != 4 * exchange.Fresh.size() + walls)
  {
    throw Error(ErrorCode::Inconsistent, "cells were replaced by others with another boundary");
  }
}
} // namespace insideout
