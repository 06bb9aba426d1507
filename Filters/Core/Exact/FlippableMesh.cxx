// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/FlippableMesh.h"

#include "Common/Buckets.h"
#include "Common/ParallelLoop.h"
#include "Common/SortedTriangle.h"
#include "Delaunay/DelaunayTetrahedra.h"
#include "Exact/MeshReader.h"
#include "Exact/Phases.h"

#include <algorithm>
#include <atomic>
#include <numeric>
#include <utility>

namespace insideout
{
namespace
{
/** Cells visited in sequence in the time of one search for a face. */
constexpr std::size_t CellsPerSearch = 20;
} // namespace

FlippableMesh::FlippableMesh(
  const std::vector<Point>& points, std::vector<Id>& same, WorkBudget& work, Monitor& monitor)
  : AllVertices(points, work)
{
  this->InfiniteVertex = this->AllVertices.Add({ { 0, 0, 0 } });
  const DelaunayTetrahedra delaunay(
    points, HullPolicy::MostCells, monitor, Phases::InsertingPoints);
  same = delaunay.FirstInPlace();
  for (Id vertex = 0; vertex < this->AllVertices.Size(); ++vertex)
  {
    this->AppendVertex(0);
  }
  const std::size_t count = static_cast<std::size_t>(delaunay.NumberOfCells());
  this->Cells.reserve(count * 5 / 4);
  this->SetCells(count,
    [&](Id id)
    {
      const DelaunayTetrahedra::Cell cell = delaunay.At(id);
      return FlippableCell{ {}, cell.Corners, cell.Neighbors, { { None, None, None, None } } };
    });
  Id finite = this->NumberOfCells() - 1;
  while (this->IsInfinite(finite))
  {
    --finite;
  }
  this->Spanning = this->Cells[finite].Corners;
}

void FlippableMesh::Star(Id vertex, std::vector<Id>& cells) const
{
  MeshReader(*this).Star(vertex, cells);
}

std::vector<Id> FlippableMesh::NeighborsOf(Id vertex) const
{
  std::vector<Id> star;
  this->Star(vertex, star);
  this->VertexMarks.Start(static_cast<Id>(this->CellOf.size()));
  this->VertexMarks.Add(vertex);
  this->VertexMarks.Add(this->InfiniteVertex);
  std::vector<Id> neighbors;
  for (const Id cell : star)
  {
    for (const Id corner : this->Cells[cell].Corners)
    {
      if (!this->VertexMarks.Has(corner))
      {
        this->VertexMarks.Add(corner);
        neighbors.push_back(corner);
      }
    }
  }
  std::sort(neighbors.begin(), neighbors.end());
  return neighbors;
}

Id FlippableMesh::FindEdge(Id u, Id v) const
{
  return MeshReader(*this).FindEdge(u, v);
}

std::vector<char> FlippableMesh::HasEdges(const std::vector<std::array<Id, 2>>& edges) const
{
  constexpr std::size_t EdgesPerTurn = 256;
  constexpr double NanosecondsPerEdge = 300;
  std::vector<char> has(edges.size());
  const std::size_t turns = (edges.size() + EdgesPerTurn - 1) / EdgesPerTurn;
  std::atomic<std::int64_t> steps{ 0 };
  ParallelLoop(turns, EdgesPerTurn * NanosecondsPerEdge,
    [&](std::size_t turn)
    {
      EdgeSearch search;
      const std::size_t end = std::min((turn + 1) * EdgesPerTurn, edges.size());
      for (std::size_t i = turn * EdgesPerTurn; i < end; ++i)
      {
        has[i] = search.Find(*this, edges[i][0], edges[i][1]) != None;
      }
      steps += search.Steps();
    });
  this->Work().Spend(steps);
  return has;
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

/** Look up each face of each cell among the triangles, which are in buckets by lowest vertex. */
void FlippableMesh::FindFacesInAllCells(
  const std::vector<Triangle>& triangles, std::vector<MeshFace>& faces) const
{
  struct Wanted
  {
    Id Middle;
    Id Highest;
    std::size_t Triangle;
  };
  constexpr double NanosecondsPerTriangle = 20;
  constexpr double NanosecondsPerCell = 40;
  const Buckets<Wanted> wanted =
    Buckets<Wanted>::Unordered(this->CellOf.size(), triangles.size(), NanosecondsPerTriangle,
      [&](std::size_t i, const auto& visit)
      {
        const Triangle t = SortedTriangle(triangles[i]).Points;
        visit(static_cast<std::size_t>(t[0]), Wanted{ t[1], t[2], i });
      });
  ParallelLoop(this->NumberOfCells(), NanosecondsPerCell,
    [&](Id cell)
    {
      for (int k = 0; k < 4 && !this->IsDead(cell); ++k)
      {
        if (this->Cells[cell].Neighbors[k] < cell)
        {
          continue;
        }
        const Triangle t = SortedTriangle(this->FaceCorners(cell, k)).Points;
        for (const Wanted& triangle : wanted[static_cast<std::size_t>(t[0])])
        {
          if (triangle.Middle == t[1] && triangle.Highest == t[2])
          {
            faces[triangle.Triangle] = { cell, k };
          }
        }
      }
    });
  this->Work().Spend(static_cast<std::int64_t>(this->Cells.size()) / MeshReader::CellsPerWork);
}

void FlippableMesh::Replace(const std::vector<Id>& old, const std::vector<Tetrahedron>& fresh)
{
  this->Replace(old, fresh, {});
}

void FlippableMesh::Replace(const std::vector<Id>& old, const std::vector<Tetrahedron>& fresh,
  const std::vector<FreshFacet>& facets, Workspace& work)
{
  Mesh::Replace(
    { old, fresh, {}, facets }, [](std::size_t, Id) { return HullPolicy::Content(); }, work);
}

std::vector<Id> FlippableMesh::AddDeadCells(std::size_t count)
{
  CheckNumber(this->Cells.size() + count);
  FlippableCell dead = {};
  dead.Corners[0] = None;
  this->Cells.resize(this->Cells.size() + count, dead);
  std::vector<Id> cells(count);
  std::iota(cells.rbegin(), cells.rend(), this->NumberOfCells() - static_cast<Id>(count));
  return cells;
}

void FlippableMesh::TakeOver(const std::vector<Id>& deadCells, std::int64_t changes)
{
  this->Own.FreeCells.insert(this->Own.FreeCells.end(), deadCells.begin(), deadCells.end());
  this->Own.Changes = std::max(this->Own.Changes, changes);
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
  this->Record(cell, this->Own);
  this->Record(neighbor, this->Own);
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
  return MeshReader(*this).VertexOffPlane(a, b, c);
}

Id FlippableMesh::AddVertex(const Point& point)
{
  this->AppendVertex(this->Own.Changes);
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
  this->AppendVertex(this->Own.Changes);
  return this->AllVertices.AddBetween(first, second, a, b, span);
}

void FlippableMesh::StartJournal()
{
  Mesh::StartJournal(this->Own);
  this->AllVertices.StartJournal();
}

void FlippableMesh::EndJournal()
{
  this->Own.Past.IsKept = false;
  this->AllVertices.EndJournal();
}

void FlippableMesh::GoBack()
{
  Mesh::GoBack(this->Own);
  this->AllVertices.GoBack();
}
} // namespace insideout
