// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/RefinableMesh.h"

#include "Common/Error.h"
#include "Common/SortedTriangle.h"

#include <algorithm>

namespace insideout
{
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

Id RefinableMesh::AddPoint(const Point& place, bool isFixed, double size)
{
  this->Points.push_back(place);
  this->IsFixed.push_back(isFixed ? 1 : 0);
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
  Id at = start;
  do
  {
    const auto [first, second] = this->OtherCorners(at, u, v);
    ring.Points.push_back(first);
    ring.Cells.push_back(at);
    const RefinableCell& here = this->Cells[at];
    const int across = this->CornerIndex(at, first);
    ring.IsLocked = ring.IsLocked || here.Facets[across] != None ||
      here.Facets[this->CornerIndex(at, second)] != None;
    at = here.Neighbors[across];
    if (at == None)
    {
      ring.Points.push_back(second);
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

/** Enter the faces between the marked cells and the rest. @return how many */
std::size_t RefinableMesh::EnterWalls(const std::vector<Id>& cells)
{
  std::size_t walls = 0;
  for (const Id cell : cells)
  {
    const RefinableCell& here = this->Cells[cell];
    for (int k = 0; k < 4; ++k)
    {
      const Id neighbor = here.Neighbors[k];
      if (neighbor == None || !this->IsMarked(neighbor))
      {
        const Triangle corners = SortedTriangle(FaceAcross(here.Corners, k)).Points;
        this->Slot(corners) = { corners, neighbor,
          neighbor == None ? 0 : this->MirrorIndex(cell, k), here.Facets[k], this->TableEpoch };
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
      pending = { face, cell, k, None, this->TableEpoch };
      continue;
    }
    this->Cells[cell].Neighbors[k] = pending.Cell;
    this->Cells[cell].Facets[k] = pending.Facet;
    if (pending.Cell != None)
    {
      this->Cells[pending.Cell].Neighbors[pending.Face] = cell;
    }
    ++matched;
  }
  return matched;
}

void RefinableMesh::Replace(const std::vector<Id>& old, const std::vector<Tetrahedron>& fresh)
{
  std::size_t size = std::max<std::size_t>(this->Table.size(), 64);
  while (size < 6 * (old.size() + fresh.size()))
  {
    size *= 2;
  }
  if (size > this->Table.size())
  {
    this->Table.assign(size, { { { None, None, None } }, None, 0, None, 0 });
    this->TableEpoch = 0;
  }
  ++this->TableEpoch;
  ++this->Changes;

  const Id region = this->Cells[old.front()].Region;
  const Id parent = this->Cells[old.front()].Parent;
  this->StartMarking();
  for (const Id cell : old)
  {
    this->Mark(cell);
  }
  const std::size_t walls = this->EnterWalls(old);
  for (const Id cell : old)
  {
    this->Remove(cell);
  }
  std::size_t matched = 0;
  this->FreshCells.clear();
  for (const Tetrahedron& corners : fresh)
  {
    const std::array<Id, 4> none = { { None, None, None, None } };
    this->FreshCells.push_back(this->NewCell({ corners, none, none, region, parent }));
    matched += this->Connect(this->FreshCells.back());
  }
  // Each face of a fresh cell is a wall, or one of two that are matched once.
  if (2 * matched != 4 * fresh.size() + walls)
  {
    throw Error(ErrorCode::Inconsistent, "cells were replaced by others with another boundary");
  }
}
} // namespace insideout
