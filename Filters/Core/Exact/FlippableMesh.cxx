// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/FlippableMesh.h"

#include "Common/Buckets.h"
#include "Common/Error.h"
#include "Common/Kernel.h"
#include "Common/SortUniquely.h"
#include "Common/SortedTriangle.h"
#include "Exact/InsertPoints.h"
#include "Exact/Phases.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace insideout
{
namespace
{
using DelaunayVertex = CGAL::Triangulation_vertex_base_with_info_3<Id, Kernel>;
using DelaunayCell = CGAL::Triangulation_cell_base_with_info_3<Id, Kernel>;
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel,
  CGAL::Triangulation_data_structure_3<DelaunayVertex, DelaunayCell>>;

/** So many cells are looked at in the time of one predicate. */
constexpr std::int64_t CellsPerWork = 2;

/** And so many, one after the other, in the time that it takes to find one face. */
constexpr std::size_t CellsPerSearch = 20;

Triangle SortedFace(const Tetrahedron& t, int k)
{
  return SortedTriangle({ t[(k + 1) % 4], t[(k + 2) % 4], t[(k + 3) % 4] }).Points;
}
} // namespace

const std::array<std::array<std::array<std::int8_t, 2>, 4>, 4> OtherCorners = { {
  { { { { 0, 0 } }, { { 2, 3 } }, { { 3, 1 } }, { { 1, 2 } } } },
  { { { { 3, 2 } }, { { 0, 0 } }, { { 0, 3 } }, { { 2, 0 } } } },
  { { { { 1, 3 } }, { { 3, 0 } }, { { 0, 0 } }, { { 0, 1 } } } },
  { { { { 2, 1 } }, { { 0, 2 } }, { { 1, 0 } }, { { 0, 0 } } } },
} };

const std::array<std::array<std::int8_t, 3>, 4> FaceSeenFrom = { { { { 1, 3, 2 } }, { { 0, 2, 3 } },
  { { 0, 3, 1 } }, { { 0, 1, 2 } } } };

FlippableMesh::FlippableMesh(
  const std::vector<Point>& points, std::vector<Id>& same, WorkBudget& work, Monitor& monitor)
  : AllVertices(points, work)
{
  this->InfiniteVertex = this->AllVertices.Add({ { 0, 0, 0 } });
  Delaunay delaunay;
  InsertPoints(
    points, delaunay, [&](double fraction) { monitor.Check(Phases::InsertingPoints, fraction); });
  if (delaunay.dimension() < 3)
  {
    throw Error(ErrorCode::Planar, "the points lie in one plane");
  }

  same.resize(points.size());
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    same[p] = static_cast<Id>(p);
  }
  if (delaunay.number_of_vertices() != points.size())
  {
    std::vector<Id> order = same;
    std::sort(order.begin(), order.end(),
      [&points](Id a, Id b) { return std::tie(points[a], a) < std::tie(points[b], b); });
    for (std::size_t k = 1; k < order.size(); ++k)
    {
      if (points[order[k]] == points[order[k - 1]])
      {
        same[order[k]] = same[order[k - 1]];
      }
    }
  }
  const auto vertexOf = [&](Delaunay::Vertex_handle vertex) -> Id
  { return vertex == delaunay.infinite_vertex() ? this->InfiniteVertex : vertex->info(); };

  this->CellOf.assign(points.size() + 1, None);
  this->ChangeAround.assign(points.size() + 1, 0);
  Id count = 0;
  for (auto cell = delaunay.all_cells_begin(); cell != delaunay.all_cells_end(); ++cell)
  {
    cell->info() = count++;
  }
  this->Cells.reserve(static_cast<std::size_t>(count) * 5 / 4);
  for (auto cell = delaunay.all_cells_begin(); cell != delaunay.all_cells_end(); ++cell)
  {
    FlippableCell copy;
    for (int k = 0; k < 4; ++k)
    {
      copy.Corners[k] = vertexOf(cell->vertex(k));
      copy.Neighbors[k] = cell->neighbor(k)->info();
      copy.Facets[k] = None;
      this->CellOf[copy.Corners[k]] = this->NumberOfCells();
    }
    if (!delaunay.is_infinite(cell))
    {
      this->Spanning = copy.Corners;
    }
    this->Cells.push_back(copy);
  }
  this->Marks.assign(this->Cells.size(), 0);
}

void FlippableMesh::Star(Id vertex, std::vector<Id>& cells) const
{
  const Id first = this->CellOf[vertex];
  if (first == None)
  {
    return;
  }
  std::size_t next = cells.size();
  this->StartMarking();
  this->Mark(first);
  cells.push_back(first);
  for (; next < cells.size(); ++next)
  {
    const FlippableCell& cell = this->Cells[cells[next]];
    for (int k = 0; k < 4; ++k)
    {
      if (cell.Corners[k] != vertex && !this->IsMarked(cell.Neighbors[k]))
      {
        this->Mark(cell.Neighbors[k]);
        cells.push_back(cell.Neighbors[k]);
      }
    }
  }
  this->Work().Spend(static_cast<std::int64_t>(cells.size()) / CellsPerWork);
}

std::vector<Id> FlippableMesh::NeighborsOf(const std::vector<Id>& points) const
{
  std::vector<Id> star;
  for (const Id point : points)
  {
    this->Star(point, star);
  }
  std::vector<Id> neighbors;
  for (const Id cell : star)
  {
    for (const Id corner : this->Cells[cell].Corners)
    {
      if (corner != this->InfiniteVertex &&
        std::find(points.begin(), points.end(), corner) == points.end())
      {
        neighbors.push_back(corner);
      }
    }
  }
  SortUniquely(neighbors);
  return neighbors;
}

Id FlippableMesh::FindEdge(Id u, Id v) const
{
  if (this->CellOf[u] == None || this->CellOf[v] == None)
  {
    return None;
  }
  if (this->Has(this->CellOf[u], v))
  {
    return this->CellOf[u];
  }
  if (this->Has(this->CellOf[v], u))
  {
    return this->CellOf[v];
  }
  // Around both in turn: the smaller star decides, where the other may have thousands of cells.
  this->StartMarking();
  const std::array<Id, 2> ends = { { u, v } };
  for (int side = 0; side < 2; ++side)
  {
    this->Mark(this->CellOf[ends[side]]);
    this->StarScratch[side].assign(1, this->CellOf[ends[side]]);
  }
  Id found = None;
  std::size_t next = 0;
  for (; found == None && next < std::min(this->StarScratch[0].size(), this->StarScratch[1].size());
       ++next)
  {
    for (int side = 0; side < 2 && found == None; ++side)
    {
      const FlippableCell& cell = this->Cells[this->StarScratch[side][next]];
      for (int k = 0; k < 4; ++k)
      {
        const Id neighbor = cell.Neighbors[k];
        if (cell.Corners[k] == ends[side] || this->IsMarked(neighbor))
        {
          continue;
        }
        if (this->Has(neighbor, ends[1 - side]))
        {
          found = neighbor;
        }
        this->Mark(neighbor);
        this->StarScratch[side].push_back(neighbor);
      }
    }
  }
  this->Work().Spend(static_cast<std::int64_t>(2 * next) / CellsPerWork);
  return found;
}

bool FlippableMesh::FindFace(Id a, Id b, Id c, Id& cell, int& face) const
{
  const Id first = this->FindEdge(a, b);
  if (first == None)
  {
    return false;
  }
  cell = first;
  do
  {
    const auto& others = OtherCorners[this->CornerIndex(cell, a)][this->CornerIndex(cell, b)];
    if (this->Cells[cell].Corners[others[0]] == c)
    {
      face = others[1];
      return true;
    }
    cell = this->Cells[cell].Neighbors[others[0]];
  } while (cell != first);
  return false;
}

std::vector<MeshFace> FlippableMesh::FindFaces(const std::vector<Triangle>& triangles) const
{
  std::vector<MeshFace> faces(triangles.size(), { None, -1 });
  if (triangles.size() < this->Cells.size() / CellsPerSearch)
  {
    this->FindFacesOneByOne(triangles, faces);
  }
  else
  {
    this->FindFacesInAllCells(triangles, faces);
  }
  return faces;
}

void FlippableMesh::FindFacesOneByOne(
  const std::vector<Triangle>& triangles, std::vector<MeshFace>& faces) const
{
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const Triangle& t = triangles[i];
    if (!this->FindFace(t[0], t[1], t[2], faces[i].Cell, faces[i].Face))
    {
      faces[i].Cell = None;
    }
  }
}

/** Look each face of each cell up among the triangles, which are in buckets by lowest vertex. */
void FlippableMesh::FindFacesInAllCells(
  const std::vector<Triangle>& triangles, std::vector<MeshFace>& faces) const
{
  struct Wanted
  {
    Id Middle;
    Id Highest;
    std::size_t Triangle;
  };
  const Buckets<Wanted> wanted(this->CellOf.size(),
    [&](const auto& visit)
    {
      for (std::size_t i = 0; i < triangles.size(); ++i)
      {
        const Triangle t = SortedTriangle(triangles[i]).Points;
        visit(static_cast<std::size_t>(t[0]), Wanted{ t[1], t[2], i });
      }
    });
  for (Id cell = 0; cell < this->NumberOfCells(); ++cell)
  {
    for (int k = 0; k < 4 && !this->IsDead(cell); ++k)
    {
      if (this->Cells[cell].Neighbors[k] < cell)
      {
        continue;
      }
      const Triangle t = SortedFace(this->Cells[cell].Corners, k);
      for (const Wanted& triangle : wanted[static_cast<std::size_t>(t[0])])
      {
        if (triangle.Middle == t[1] && triangle.Highest == t[2])
        {
          faces[triangle.Triangle] = { cell, k };
        }
      }
    }
  }
  this->Work().Spend(static_cast<std::int64_t>(this->Cells.size()) / CellsPerWork);
}

void FlippableMesh::Ring(Id u, Id v, Id cell, EdgeRing& ring) const
{
  ring.U = u;
  ring.V = v;
  ring.Points.clear();
  ring.Cells.clear();
  const Id first = cell;
  do
  {
    const auto& others = OtherCorners[this->CornerIndex(cell, u)][this->CornerIndex(cell, v)];
    ring.Points.push_back(this->Cells[cell].Corners[others[0]]);
    ring.Cells.push_back(cell);
    cell = this->Cells[cell].Neighbors[others[0]];
  } while (cell != first);
}

Id FlippableMesh::NewCell()
{
  if (!this->FreeCells.empty())
  {
    const Id cell = this->FreeCells.back();
    this->FreeCells.pop_back();
    return cell;
  }
  this->Cells.push_back({});
  this->Marks.push_back(0);
  return static_cast<Id>(this->Cells.size() - 1);
}

FlippableMesh::PendingFace& FlippableMesh::Slot(const std::array<Id, 3>& corners)
{
  const std::size_t mask = this->Table.size() - 1;
  std::size_t slot = (static_cast<std::size_t>(corners[0]) * 0x9E3779B1u ^
    static_cast<std::size_t>(corners[1]) * 0x85EBCA77u ^
    static_cast<std::size_t>(corners[2]) * 0xC2B2AE3Du);
  slot = (slot ^ (slot >> 15)) & mask;
  while (this->Table[slot].Cell != None && this->Table[slot].Corners != corners)
  {
    slot = (slot + 1) & mask;
  }
  return this->Table[slot];
}

void FlippableMesh::Replace(const std::vector<Id>& old, const std::vector<Tetrahedron>& fresh)
{
  ++this->Changes;
  std::size_t size = 16;
  while (size < 6 * (old.size() + fresh.size()))
  {
    size *= 2;
  }
  this->Table.assign(size, { { { None, None, None } }, None, 0, None });

  this->StartMarking();
  for (const Id cell : old)
  {
    this->Mark(cell);
  }
  std::size_t open = 0;
  for (const Id cell : old)
  {
    for (int k = 0; k < 4; ++k)
    {
      const Id neighbor = this->Cells[cell].Neighbors[k];
      if (!this->IsMarked(neighbor))
      {
        const Triangle corners = SortedFace(this->Cells[cell].Corners, k);
        this->Slot(
          corners) = { corners, neighbor, this->MirrorIndex(cell, k), this->Cells[cell].Facets[k] };
        ++open;
      }
    }
  }
  for (const Id cell : old)
  {
    // A vertex that is left without a cell gets one back below, or is no longer in the mesh.
    for (const Id corner : this->Cells[cell].Corners)
    {
      this->CellOf[corner] = None;
    }
    this->Cells[cell].Corners[0] = None;
    this->FreeCells.push_back(cell);
  }
  std::size_t matched = 0;
  for (const Tetrahedron& corners : fresh)
  {
    const Id cell = this->NewCell();
    this->Marks[cell] = 0;
    this->Cells[cell] = { corners, { { None, None, None, None } }, { { None, None, None, None } } };
    for (int k = 0; k < 4; ++k)
    {
      this->CellOf[corners[k]] = cell;
      this->ChangeAround[corners[k]] = this->Changes;
      const Triangle face = SortedFace(corners, k);
      PendingFace& pending = this->Slot(face);
      if (pending.Cell == None)
      {
        pending = { face, cell, k, None };
        ++open;
        continue;
      }
      this->Cells[cell].Neighbors[k] = pending.Cell;
      this->Cells[cell].Facets[k] = pending.Facet;
      this->Cells[pending.Cell].Neighbors[pending.Face] = cell;
      ++matched;
    }
  }
  if (matched != open)
  {
    throw Error(ErrorCode::Inconsistent, "cells were replaced by others with another boundary");
  }
}

void FlippableMesh::SplitCell(Id cell, Id vertex)
{
  std::vector<Tetrahedron> fresh(4, this->Cells[cell].Corners);
  for (int k = 0; k < 4; ++k)
  {
    fresh[k][k] = vertex;
  }
  this->Replace({ cell }, fresh);
}

void FlippableMesh::SplitEdge(const EdgeRing& ring, Id vertex)
{
  std::vector<Tetrahedron> fresh;
  for (const Id cell : ring.Cells)
  {
    for (const Id end : { ring.U, ring.V })
    {
      fresh.push_back(this->Cells[cell].Corners);
      fresh.back()[this->CornerIndex(cell, end)] = vertex;
    }
  }
  this->Replace(std::vector<Id>(ring.Cells), fresh);
}

void FlippableMesh::SetFacet(Id cell, int face, Id facet)
{
  const Id neighbor = this->Cells[cell].Neighbors[face];
  this->Cells[neighbor].Facets[this->MirrorIndex(cell, face)] = facet;
  this->Cells[cell].Facets[face] = facet;
}

void FlippableMesh::MarkFace(Id a, Id b, Id c, Id facet)
{
  Id cell;
  int face;
  if (facet != None && this->FindFace(a, b, c, cell, face))
  {
    this->SetFacet(cell, face, facet);
  }
}

Id FlippableMesh::VertexOffPlane(Id a, Id b, Id c) const
{
  for (const Id vertex : this->Spanning)
  {
    if (this->AllVertices.Orient(a, b, c, vertex) != 0)
    {
      return vertex;
    }
  }
  return None;
}

Id FlippableMesh::AddVertex(const Point& point)
{
  this->CellOf.push_back(None);
  this->ChangeAround.push_back(this->Changes);
  return this->AllVertices.Add(point);
}

void FlippableMesh::RemoveLastVertex()
{
  this->CellOf.pop_back();
  this->ChangeAround.pop_back();
  this->AllVertices.RemoveLast();
}

Id FlippableMesh::AddVertexBetween(Id first, Id second, const DyadicNumber& a,
  const DyadicNumber& b, const ExactVertices::Span& span)
{
  this->CellOf.push_back(None);
  this->ChangeAround.push_back(this->Changes);
  return this->AllVertices.AddBetween(first, second, a, b, span);
}
} // namespace insideout
