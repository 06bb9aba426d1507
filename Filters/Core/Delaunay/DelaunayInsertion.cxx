// SPDX-License-Identifier: GPL-3.0-or-later
#include "Delaunay/DelaunayInsertion.h"

#include "Common/PointPredicates.h"
#include "Delaunay/PerturbedSphere.h"
#include "Mesh/MeshCell.h"

#include <algorithm>
#include <tuple>

namespace insideout
{
namespace
{
/** Cells that a thread takes at once. */
constexpr std::size_t CellsAtOnce = 256;

/** Cells that connect more vertices are connected by sorting: a table would be large. */
constexpr std::size_t MostInTable = 128;

/** A search that takes as many steps was led astray by cells that other threads changed. */
constexpr int MostSteps = 1 << 24;

// Instead of a face (DelaunayInsertion::FaceTowards).
constexpr int InTheCell = -1;
constexpr int NoLongerThere = -2;
} // namespace

DelaunayInsertion::DelaunayInsertion(DelaunayCells& cells, std::uint32_t thread)
  : Cells(cells)
  , Thread(thread)
{
}

Inserted DelaunayInsertion::Insert(Id vertex, Id& other)
{
  const Point point = this->Cells.PointOf(vertex);
  const Id first = this->Walk(point);
  Inserted result = Inserted::Busy;
  // With the vertex itself held, no other thread can hold a cell that is not finished.
  if (first != None && this->Hold(vertex) && this->HoldCell(first, point))
  {
    other = this->VertexAt(first, point);
    if (other != None)
    {
      result = Inserted::Coincides;
    }
    else if (this->FindCellsThatGo(first, point))
    {
      if (this->Free.size() < this->Outer.size())
      {
        this->Cells.Take(this->Outer.size() + CellsAtOnce, this->Free);
      }
      result = this->Free.size() < this->Outer.size() ? Inserted::NoRoom : Inserted::Fresh;
    }
  }
  if (result == Inserted::Fresh)
  {
    this->Replace(vertex);
  }
  this->Undo();
  return result;
}

/**
 * The face of a cell beyond which the point is, or InTheCell. A cell at the infinite vertex holds
 * what is beyond its face on the hull.
 * @param[in] from a face before which it is, -1 for none
 */
int DelaunayInsertion::FaceTowards(Id cell, int from, const Point& point) const
{
  std::array<const Point*, 4> corners;
  const DelaunayCell& at = this->Cells[cell];
  const bool isInfinite = at.Corner(3) == InfiniteVertex;
  for (int k = 0; k < 4; ++k)
  {
    const Id corner = at.Corner(k);
    if (corner == None)
    {
      return NoLongerThere;
    }
    corners[k] = &this->Cells.PointOf(corner);
  }
  for (int k = isInfinite ? 3 : 0; k < 4; ++k)
  {
    if (k == from)
    {
      continue;
    }
    const Point* const corner = corners[k];
    corners[k] = &point;
    const int side = Orient3D(*corners[0], *corners[1], *corners[2], *corners[3]);
    corners[k] = corner;
    if (isInfinite ? side <= 0 : side < 0)
    {
      return k;
    }
  }
  return InTheCell;
}

/** The cell that holds the point, as far as can be seen while other threads work, or None. */
Id DelaunayInsertion::Walk(const Point& point) const
{
  Id cell = this->Start;
  int from = -1;
  for (int steps = 0; steps < MostSteps; ++steps)
  {
    const int face = this->FaceTowards(cell, from, point);
    if (face == InTheCell)
    {
      return cell;
    }
    const Id next = face == NoLongerThere ? None : this->Cells[cell].Neighbor(face);
    const bool isReplaced = next < 0; // then another one may still be there
    cell = isReplaced ? (cell + 1) % static_cast<Id>(this->Cells.NumberOfIds()) : CellOfFace(next);
    from = isReplaced ? -1 : CornerAcross(next);
  }
  return None;
}

bool DelaunayInsertion::Hold(Id vertex)
{
  const std::uint32_t holder =
    this->Cells.Hold(vertex, this->Thread, static_cast<std::uint32_t>(this->Held.size() + 1));
  if (holder == 0)
  {
    this->Held.push_back(vertex);
  }
  return holder == 0 || holder == this->Thread;
}

/** Hold the corners of the cell that Walk found, if it is still there and holds the point. */
bool DelaunayInsertion::HoldCell(Id cell, const Point& point)
{
  std::array<Id, 4> corners;
  for (int k = 0; k < 4; ++k)
  {
    corners[k] = this->Cells[cell].Corner(k);
    if (corners[k] == None || (corners[k] != InfiniteVertex && !this->Hold(corners[k])))
    {
      return false;
    }
  }
  for (int k = 0; k < 4; ++k)
  {
    if (this->Cells[cell].Corner(k) != corners[k])
    {
      return false;
    }
  }
  return this->FaceTowards(cell, -1, point) == InTheCell;
}

/** The corner of a cell in the place of a point, or None. */
Id DelaunayInsertion::VertexAt(Id cell, const Point& point) const
{
  for (int k = 0; k < 4; ++k)
  {
    const Id corner = this->Cells[cell].Corner(k);
    if (corner != InfiniteVertex && this->Cells.PointOf(corner) == point)
    {
      return corner;
    }
  }
  return None;
}

/** Whether a point is within the sphere of a cell. The sphere of an infinite cell is the half space
 * beyond its face; on the plane it is that of the cell on the other side. */
bool DelaunayInsertion::IsInConflict(Id cell, const Point& point) const
{
  const DelaunayCell* at = &this->Cells[cell];
  const auto corner = [&](int k) -> const Point& { return this->Cells.PointOf(at->Corner(k)); };
  if (at->Corner(3) == InfiniteVertex)
  {
    const int side = Orient3D(corner(0), corner(1), corner(2), point);
    if (side != 0)
    {
      return side > 0;
    }
    at = &this->Cells[CellOfFace(at->Neighbor(3))];
  }
  return IsInSphere(corner(0), corner(1), corner(2), corner(3), point);
}

/**
 * Collect the cells that go, from one of them on, and their outer faces, and hold their vertices.
 * @return false if another thread holds one
 */
bool DelaunayInsertion::FindCellsThatGo(Id first, const Point& point)
{
  this->Cells.SetState(first, CellState::Goes);
  this->Going.push_back(first);
  for (std::size_t i = 0; i < this->Going.size(); ++i)
  {
    const Id cell = this->Going[i];
    for (int k = 0; k < 4; ++k)
    {
      const Id face = this->Cells[cell].Neighbor(k);
      const Id next = CellOfFace(face);
      CellState state = this->Cells.State(next);
      if (state == CellState::Unknown)
      {
        const bool goes = this->IsInConflict(next, point);
        if (goes)
        {
          const Id apex = this->Cells[next].Corner(CornerAcross(face));
          if (apex != InfiniteVertex && !this->Hold(apex))
          {
            return false;
          }
        }
        state = goes ? CellState::Goes : CellState::Stays;
        this->Cells.SetState(next, state);
        (goes ? this->Going : this->Staying).push_back(next);
      }
      if (state == CellState::Stays)
      {
        this->Outer.push_back({ cell, k });
      }
    }
  }
  return true;
}

/** Replace the cells that go by cells between the vertex and their outer faces. */
void DelaunayInsertion::Replace(Id vertex)
{
  for (OuterFace& outer : this->Outer)
  {
    const Id fresh = this->Free.back();
    this->Free.pop_back();
    const DelaunayCell& old = this->Cells[outer.Cell];
    DelaunayCell& cell = this->Cells[fresh];
    for (int k = 0; k < 4; ++k)
    {
      cell.SetCorner(k, old.Corner(k));
    }
    cell.SetCorner(outer.Face, vertex);
    const Id beyond = old.Neighbor(outer.Face);
    cell.SetNeighbor(outer.Face, beyond);
    this->Cells[CellOfFace(beyond)].SetNeighbor(
      CornerAcross(beyond), FaceNumber(fresh, outer.Face));
    outer.Cell = fresh;
  }
  this->Start = this->Outer.back().Cell;
  if (this->Held.size() < MostInTable)
  {
    this->ConnectByTable();
  }
  else
  {
    this->ConnectBySorting();
  }
  for (const Id cell : this->Going)
  {
    this->Cells[cell].SetCorner(0, None);
    this->Free.push_back(cell);
  }
}

/** Connect the fresh cells by a table of the edges between held vertices: of two faces at an edge,
 * one has it as (a, b), and the other as (b, a). */
void DelaunayInsertion::ConnectByTable()
{
  const std::size_t size = this->Held.size() + 1;
  this->Table.resize(std::max(this->Table.size(), size * size));
  this->Places.clear();
  for (const OuterFace& outer : this->Outer)
  {
    const auto& base = FaceSeenFrom[outer.Face];
    std::array<std::size_t, 3> places;
    for (int i = 0; i < 3; ++i)
    {
      places[i] = this->Cells.PlaceOf(this->Cells[outer.Cell].Corner(base[i]));
    }
    this->Table[places[1] * size + places[2]] = FaceNumber(outer.Cell, base[0]);
    this->Table[places[2] * size + places[0]] = FaceNumber(outer.Cell, base[1]);
    this->Table[places[0] * size + places[1]] = FaceNumber(outer.Cell, base[2]);
    this->Places.push_back(places);
  }
  for (std::size_t f = 0; f < this->Outer.size(); ++f)
  {
    DelaunayCell& cell = this->Cells[this->Outer[f].Cell];
    const auto& base = FaceSeenFrom[this->Outer[f].Face];
    const std::array<std::size_t, 3>& places = this->Places[f];
    cell.SetNeighbor(base[0], this->Table[places[2] * size + places[1]]);
    cell.SetNeighbor(base[1], this->Table[places[0] * size + places[2]]);
    cell.SetNeighbor(base[2], this->Table[places[1] * size + places[0]]);
  }
}

/** The same where a table were too large. */
void DelaunayInsertion::ConnectBySorting()
{
  struct Side
  {
    Id Low;
    Id High;
    Id Face;
  };
  std::vector<Side> sides;
  for (const OuterFace& outer : this->Outer)
  {
    const auto& base = FaceSeenFrom[outer.Face];
    for (int i = 0; i < 3; ++i)
    {
      const Id a = this->Cells[outer.Cell].Corner(base[(i + 1) % 3]);
      const Id b = this->Cells[outer.Cell].Corner(base[(i + 2) % 3]);
      sides.push_back({ std::min(a, b), std::max(a, b), FaceNumber(outer.Cell, base[i]) });
    }
  }
  std::sort(sides.begin(), sides.end(),
    [](const Side& a, const Side& b) { return std::tie(a.Low, a.High) < std::tie(b.Low, b.High); });
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    const Id face = sides[i].Face;
    this->Cells[CellOfFace(face)].SetNeighbor(CornerAcross(face), sides[i ^ 1].Face);
  }
}

/** Forget what the search collected, and release all vertices. */
void DelaunayInsertion::Undo()
{
  for (std::vector<Id>* const cells : { &this->Going, &this->Staying })
  {
    for (const Id cell : *cells)
    {
      this->Cells.SetState(cell, CellState::Unknown);
    }
    cells->clear();
  }
  this->Outer.clear();
  for (const Id vertex : this->Held)
  {
    this->Cells.Release(vertex);
  }
  this->Held.clear();
}
} // namespace insideout
