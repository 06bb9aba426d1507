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
  // Two cells may share two faces only where a point has no other cells; then corners tell.
  for (int i = 0; i < 4; ++i)
  {
    if (back[i] == cell)
    {
      const Id other = this->Cells[cell].Neighbors[k];
      const Id apex = this->Cells[other].Corners[i];
      const Tetrahedron& corners = this->Cells[cell].Corners;
      if (std::find(corners.begin(), corners.end(), apex) == corners.end())
      {
        return i;
      }
    }
  }
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

void RefinableMesh::RemoveLastPoint()
{
  this->Points.pop_back();
  this->IsFixed.pop_back();
  this->Sizes.pop_back();
  this->CellOf.pop_back();
  this->Changed.pop_back();
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

void RefinableMesh::Ring(Id u, Id v, Id cell, RefinableRing& ring) const
{
  ring.U = u;
  ring.V = v;
  ring.IsLocked = false;
  ring.Points.clear();
  ring.Cells.clear();
  // The two other corners of a cell, so that (u, v, first, second) is positive.
  const auto others = [&](Id c, Id& first, Id& second)
  {
    const int i = this->CornerIndex(c, u);
    const int j = this->CornerIndex(c, v);
    // The face across from u, beginning with v, is (v, second, first) seen from u.
    const Triangle face = FaceAcross(this->Cells[c].Corners, i);
    const int at = face[0] == v ? 0 : face[1] == v ? 1 : 2;
    first = face[(at + 2) % 3];
    second = face[(at + 1) % 3];
    static_cast<void>(j);
  };
  // Turn backward to the boundary, if there is one, then forward.
  Id start = cell;
  for (;;)
  {
    Id first = None;
    Id second = None;
    others(start, first, second);
    const Id before = this->Cells[start].Neighbors[this->CornerIndex(start, second)];
    if (before == None || before == cell)
    {
      ring.IsClosed = before != None;
      break;
    }
    start = before;
  }
  if (ring.IsClosed)
  {
    start = cell;
  }
  for (Id at = start;;)
  {
    Id first = None;
    Id second = None;
    others(at, first, second);
    ring.Points.push_back(first);
    ring.Cells.push_back(at);
    const RefinableCell& here = this->Cells[at];
    const int across = this->CornerIndex(at, first);
    ring.IsLocked = ring.IsLocked || here.Facets[across] != None ||
      here.Facets[this->CornerIndex(at, second)] != None;
    const Id next = here.Neighbors[across];
    if (next == None)
    {
      ring.Points.push_back(second);
      break;
    }
    if (next == start)
    {
      break;
    }
    at = next;
  }
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

void RefinableMesh::Replace(const std::vector<Id>& old, const std::vector<Tetrahedron>& fresh,
  const std::vector<std::array<Id, 4>>& facets)
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
  std::size_t open = 0;
  for (const Id cell : old)
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
        ++open;
      }
    }
  }
  for (const Id cell : old)
  {
    // A point that is left without a cell gets one back below, or is no longer in the mesh.
    for (const Id corner : this->Cells[cell].Corners)
    {
      this->CellOf[corner] = None;
    }
    this->Cells[cell].Corners[0] = None;
    ++this->Versions[cell];
    this->FreeCells.push_back(cell);
  }
  std::size_t matched = 0;
  this->FreshCells.clear();
  for (std::size_t f = 0; f < fresh.size(); ++f)
  {
    Id cell = this->NumberOfCells();
    if (this->FreeCells.empty())
    {
      this->Cells.emplace_back();
      this->Versions.push_back(0);
      this->Marks.push_back(0);
    }
    else
    {
      cell = this->FreeCells.back();
      this->FreeCells.pop_back();
    }
    this->FreshCells.push_back(cell);
    this->Marks[cell] = 0;
    this->Cells[cell] = { fresh[f], { { None, None, None, None } }, { { None, None, None, None } },
      region, parent };
    if (!facets.empty())
    {
      this->Cells[cell].Facets = facets[f];
    }
    for (int k = 0; k < 4; ++k)
    {
      this->CellOf[fresh[f][k]] = cell;
      this->Changed[fresh[f][k]] = this->Changes;
      const Triangle face = SortedTriangle(FaceAcross(fresh[f], k)).Points;
      PendingFace& pending = this->Slot(face);
      if (pending.Epoch != this->TableEpoch)
      {
        pending = { face, cell, k, None, this->TableEpoch };
        ++open;
        continue;
      }
      this->Cells[cell].Neighbors[k] = pending.Cell;
      if (pending.Facet != None)
      {
        this->Cells[cell].Facets[k] = pending.Facet;
      }
      if (pending.Cell != None)
      {
        this->Cells[pending.Cell].Neighbors[pending.Face] = cell;
      }
      ++matched;
    }
  }
  if (matched != open)
  {
    throw Error(ErrorCode::Inconsistent, "cells were replaced by others with another boundary");
  }
}
} // namespace insideout
