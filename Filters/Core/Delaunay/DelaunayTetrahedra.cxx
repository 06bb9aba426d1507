// SPDX-License-Identifier: GPL-3.0-or-later
#include "Delaunay/DelaunayTetrahedra.h"

#include "Common/Buckets.h"
#include "Common/PointPredicates.h"
#include "Mesh/MeshCell.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace insideout
{
namespace
{
constexpr double NanosecondsPerCell = 20;
constexpr double NanosecondsPerSortedVertex = 200;
constexpr std::size_t FirstCells = 5;

/** The places of the vertices, the first of which is at infinity. */
std::vector<Point> PlacesOfVertices(const std::vector<Point>& points, const std::vector<Id>& order)
{
  std::vector<Point> places(points.size() + 1, Point{ { 0, 0, 0 } });
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    places[i + 1] = points[static_cast<std::size_t>(order[i])];
  }
  return places;
}

/** Make the tetrahedron of vertices 1 to 4, and those around it. */
void MakeFirstCells(DelaunayCells& cells)
{
  std::vector<Id> ids;
  cells.Take(FirstCells, ids);
  Tetrahedron inner = { { 1, 2, 3, 4 } };
  if (Orient3D(cells.PointOf(1), cells.PointOf(2), cells.PointOf(3), cells.PointOf(4)) < 0)
  {
    std::swap(inner[0], inner[1]);
  }
  std::vector<Tetrahedron> corners = { inner };
  for (int k = 0; k < 4; ++k)
  {
    const Triangle face = FaceAcross(inner, k); // turned to the outside
    corners.push_back({ { face[0], face[2], face[1], InfiniteVertex } });
  }
  for (std::size_t c = 0; c < corners.size(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      cells[ids[c]].SetCorner(k, corners[c][k]);
    }
    for (std::size_t d = 0; d < corners.size(); ++d)
    {
      for (int k = 0; k < 4 && c != d; ++k)
      {
        if (CornerIndexIn(corners[c], corners[d][k]) < 0)
        {
          // Each of any two cells lacks one of the other's corners.
          const auto lacks = [&](Id corner) { return CornerIndexIn(corners[d], corner) < 0; };
          const auto across = std::find_if(corners[c].begin(), corners[c].end(), lacks);
          cells[ids[c]].SetNeighbor(
            static_cast<int>(across - corners[c].begin()), FaceNumber(ids[d], k));
        }
      }
    }
  }
}

/** A cell's vertices, from the last one on. */
Tetrahedron Descending(const DelaunayCell& cell)
{
  Tetrahedron corners = cell.AllCorners();
  const auto order = [&corners](int j, int k)
  {
    const Id larger = std::max(corners[j], corners[k]);
    corners[k] = std::min(corners[j], corners[k]);
    corners[j] = larger;
  };
  order(0, 1);
  order(2, 3);
  order(0, 2);
  order(1, 3);
  order(1, 2);
  return corners;
}
} // namespace

DelaunayTetrahedra::DelaunayTetrahedra(const std::vector<Point>& points, std::size_t most,
  Monitor& monitor, const ProgressRange& progress)
  : Order(OrderOfInsertion(points))
  , Cells(PlacesOfVertices(points, this->Order.Points))
  , First(points.size())
  , PointOf(1, static_cast<Id>(points.size()))
{
  std::iota(this->First.begin(), this->First.end(), 0);
  this->PointOf.insert(this->PointOf.end(), this->Order.Points.begin(), this->Order.Points.end());
  this->Cells.Reserve(FirstCells, FirstCells);
  MakeFirstCells(this->Cells);
  InsertionRounds rounds(this->Cells, most);
  std::size_t inserted = 4;
  const auto progressAt = [&](std::size_t part)
  { return progress.At(static_cast<double>(part) / static_cast<double>(points.size())); };
  for (const std::size_t end : this->Order.Rounds)
  {
    if (end > inserted)
    {
      rounds.Insert(
        inserted + 1, end + 1, monitor, { progress.Stage, progressAt(inserted), progressAt(end) });
      inserted = end;
    }
  }
  this->JoinCoincident(rounds.Coincidences());
  this->NumberCells();
}

/** Which of several vertices in one place is in the mesh depends on the threads: from here on it is
 * the first one of the order, and the first point. */
void DelaunayTetrahedra::JoinCoincident(const std::vector<Coincidence>& coincidences)
{
  struct Names
  {
    Id Vertex;
    Id Point;
  };
  std::unordered_map<Id, Names> names; // by the vertex that is in the mesh
  for (const Coincidence& c : coincidences)
  {
    Names& name =
      names.try_emplace(c.Other, Names{ c.Other, this->PointOf[c.Other] }).first->second;
    name.Vertex = std::min(name.Vertex, c.Vertex);
    name.Point = std::min(name.Point, this->PointOf[c.Vertex]);
  }
  for (const Coincidence& c : coincidences)
  {
    const Id point = names.at(c.Other).Point;
    this->First[this->PointOf[c.Vertex]] = point;
    this->First[this->PointOf[c.Other]] = point;
  }
  std::vector<Id> vertices(names.empty() ? 0 : this->PointOf.size());
  std::iota(vertices.begin(), vertices.end(), 0);
  for (const auto& [vertex, name] : names)
  {
    vertices[vertex] = name.Vertex;
    this->PointOf[name.Vertex] = name.Point;
  }
  if (!names.empty())
  {
    this->Rename(vertices);
  }
}

void DelaunayTetrahedra::Rename(const std::vector<Id>& names)
{
  ParallelLoop(this->Cells.NumberOfIds(), NanosecondsPerCell,
    [&](std::size_t id)
    {
      DelaunayCell& cell = this->Cells[static_cast<Id>(id)];
      for (int k = 0; k < 4 && cell.Corner(k) != None; ++k)
      {
        cell.SetCorner(k, names[cell.Corner(k)]);
      }
    });
}

/** Number the cells by their vertices, from each one's last on, so that a cell is near those before
 * it. */
void DelaunayTetrahedra::NumberCells()
{
  const std::size_t ids = this->Cells.NumberOfIds();
  struct Named
  {
    Triangle Others; ///< its other vertices, from the last one on
    Id Cell;
  };
  Buckets<Named> byLast = Buckets<Named>::Unordered(this->PointOf.size(), ids, NanosecondsPerCell,
    [&](std::size_t id, const auto& visit)
    {
      const Id cell = static_cast<Id>(id);
      if (this->Cells.IsThere(cell))
      {
        const Tetrahedron vertices = Descending(this->Cells[cell]);
        visit(static_cast<std::size_t>(vertices[0]),
          Named{ { { vertices[1], vertices[2], vertices[3] } }, cell });
      }
    });
  ParallelLoop(byLast.Size(), NanosecondsPerSortedVertex,
    [&](std::size_t vertex)
    { byLast.Sort(vertex, [](const Named& a, const Named& b) { return a.Others < b.Others; }); });
  const RawVector<Named> cells = std::move(byLast).TakeAll();
  this->IdOf.resize(cells.size());
  this->NumberOf.assign(ids, None);
  ParallelLoop(this->IdOf.size(), NanosecondsPerCell,
    [&](std::size_t cell)
    {
      this->IdOf[cell] = cells[cell].Cell;
      this->NumberOf[cells[cell].Cell] = static_cast<Id>(cell);
    });
}

DelaunayTetrahedra::Cell DelaunayTetrahedra::At(Id cell) const
{
  const DelaunayCell& from = this->Cells[this->IdOf[cell]];
  struct Corner
  {
    Id Point;
    Id Neighbor;
  };
  std::array<Corner, 4> corners;
  bool isPositive = true;
  for (int k = 0; k < 4; ++k)
  {
    corners[k] = { this->PointOf[from.Corner(k)], this->NumberOf[CellOfFace(from.Neighbor(k))] };
    for (int j = k; j > 0 && corners[j].Point < corners[j - 1].Point; --j)
    {
      std::swap(corners[j], corners[j - 1]);
      isPositive = !isPositive;
    }
  }
  if (!isPositive)
  {
    std::swap(corners[0], corners[1]);
  }
  Cell result;
  for (int k = 0; k < 4; ++k)
  {
    result.Corners[k] = corners[k].Point;
    result.Neighbors[k] = corners[k].Neighbor;
  }
  return result;
}
} // namespace insideout
