// SPDX-License-Identifier: GPL-3.0-or-later
#include "Support/FlippableMeshes.h"

#include "Common/SortedTriangle.h"
#include "Exact/Flips.h"
#include "Support/ExactReference.h"
#include "Support/FlippableMeshLaws.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace testflips
{
WorkBudget& AnyWork()
{
  static WorkBudget work;
  return work;
}

Monitor& AnyMonitor()
{
  static Monitor monitor;
  return monitor;
}

FlippableMesh DelaunayMesh(const std::vector<Point>& points, WorkBudget& work)
{
  Monitor monitor;
  std::vector<Id> same;
  return FlippableMesh(points, same, work, monitor);
}

FlippableMesh MeshOfCells(const std::vector<Point>& points, const std::vector<Tetrahedron>& cells)
{
  FlippableMesh mesh = DelaunayMesh(points);
  std::vector<Id> old;
  for (Id cell = 0; cell < NumberOfCells(mesh); ++cell)
  {
    old.push_back(cell);
  }
  std::vector<Tetrahedron> fresh = cells;
  std::map<Triangle, Tetrahedron> open;
  for (Tetrahedron& t : fresh)
  {
    if (mesh.Vertices().Orient(t[0], t[1], t[2], t[3]) < 0)
    {
      std::swap(t[0], t[1]);
    }
    for (int k = 0; k < 4; ++k)
    {
      const Triangle face =
        SortedTriangle(Triangle{ { t[(k + 1) % 4], t[(k + 2) % 4], t[(k + 3) % 4] } }).Points;
      Tetrahedron beyond = t;
      beyond[k] = mesh.Infinite();
      std::swap(beyond[(k + 1) % 4], beyond[(k + 2) % 4]);
      if (!open.insert({ face, beyond }).second)
      {
        open.erase(face);
      }
    }
  }
  for (const auto& face : open)
  {
    fresh.push_back(face.second);
  }
  mesh.Replace(old, fresh);
  return mesh;
}

std::vector<Tetrahedron> Pyramids(
  const std::vector<Triangle>& triangles, const std::vector<Id>& apexes)
{
  std::vector<Tetrahedron> cells;
  for (const Triangle& t : triangles)
  {
    for (const Id apex : apexes)
    {
      cells.push_back({ { t[0], t[1], t[2], apex } });
    }
  }
  return cells;
}

std::vector<Point> GridPoints(std::mt19937& random, int count, int size)
{
  std::set<Point> known;
  std::vector<Point> points;
  const auto add = [&](const Point& p)
  {
    if (known.insert(p).second)
    {
      points.push_back(p);
    }
  };
  add({ { 0, 0, 0 } });
  add({ { 1, 0, 0 } });
  add({ { 0, 1, 0 } });
  add({ { 0, 0, 1 } });
  const auto coordinate = [&]()
  { return static_cast<double>(random() % static_cast<unsigned>(size)); };
  while (points.size() < static_cast<std::size_t>(count))
  {
    const double x = coordinate();
    const double y = coordinate();
    add({ { x, y, coordinate() } });
  }
  return points;
}

std::vector<Point> RandomPoints(std::mt19937& random, int count)
{
  std::uniform_real_distribution<double> coordinate(0, 1);
  std::vector<Point> points(static_cast<std::size_t>(count));
  for (Point& p : points)
  {
    for (double& x : p)
    {
      x = coordinate(random);
    }
  }
  return points;
}

std::vector<Point> AnyPoints(unsigned seed, int count)
{
  std::mt19937 random(seed);
  return seed % 2 == 1 ? GridPoints(random, count, 4) : RandomPoints(random, count);
}

MeshWithFacets::MeshWithFacets(FlippableMesh mesh, std::vector<Triangle> facets, Monitor& monitor)
  : ExactState(std::move(mesh), std::move(facets), monitor)
{
  const std::vector<MeshFace> faces = this->Mesh.FindFaces(this->Facets);
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    if (faces[f].Cell != None)
    {
      this->Mesh.SetFacet(faces[f].Cell, faces[f].Face, static_cast<Id>(f));
    }
  }
}

Id MeshWithFacets::SplitEdge(Id u, Id v, const Weights& weights)
{
  EdgeRing ring;
  this->Mesh.Ring(u, v, this->Mesh.FindEdge(u, v), ring);
  const std::size_t n = ring.Points.size();
  std::vector<Id> facets;
  for (std::size_t k = 0; k < n; ++k)
  {
    const int face = this->Mesh.CornerIndex(ring.Cells[k], ring.Points[(k + 1) % n]);
    facets.push_back(CellAt(this->Mesh, ring.Cells[k]).Facets[face]);
  }
  const Id segment = this->Segments.Find(u, v);
  const std::array<Id, 2> ends =
    segment == None ? std::array<Id, 2>{ { u, v } } : this->Segments.EndsOf(segment);
  const Id point = this->Mesh.AddVertexBetween(u, v, DyadicNumber(weights.First),
    DyadicNumber(weights.Second), { { ends[0], ends[1], ends[1] } });
  this->Mesh.SplitEdge(ring, point);
  for (std::size_t k = 0; k < n; ++k)
  {
    for (const Id end : { u, v })
    {
      const MeshFace face = this->Mesh.FindFaces({ { { point, end, ring.Points[k] } } })[0];
      this->Mesh.SetFacet(face.Cell, face.Face, facets[k]);
    }
  }
  if (segment != None)
  {
    this->Segments.Split(segment, u, v, point);
  }
  return point;
}

Id MeshWithFacets::SplitFace(const MeshFace& face)
{
  const FlippableCell cell = CellAt(this->Mesh, face.Cell);
  const Id neighbor = cell.Neighbors[face.Face];
  Triangle corners;
  for (int k = 0; k < 3; ++k)
  {
    corners[k] = cell.Corners[FaceSeenFrom[face.Face][k]];
  }
  const Id facet = cell.Facets[face.Face];
  const Triangle& span = facet == None ? corners : this->Facets[facet];
  const DyadicNumber first(Weights().First);
  const DyadicNumber second(Weights().Second);
  const Id middle = this->Mesh.AddVertexBetween(corners[0], corners[1], first, second, span);
  const Id point = this->Mesh.AddVertexBetween(middle, corners[2], first, second, span);
  std::vector<Tetrahedron> fresh;
  for (const Id side : { face.Cell, neighbor })
  {
    for (const Id corner : corners)
    {
      fresh.push_back(CellAt(this->Mesh, side).Corners);
      std::replace(fresh.back().begin(), fresh.back().end(), corner, point);
    }
  }
  this->Mesh.Replace({ face.Cell, neighbor }, fresh);
  for (int k = 0; k < 3; ++k)
  {
    const MeshFace piece =
      this->Mesh.FindFaces({ { { point, corners[k], corners[(k + 1) % 3] } } })[0];
    this->Mesh.SetFacet(piece.Cell, piece.Face, facet);
  }
  return point;
}

Id MeshWithFacets::SplitCell(Id cell)
{
  const Tetrahedron corners = CellAt(this->Mesh, cell).Corners;
  Point middle = { { 0, 0, 0 } };
  for (const Id corner : corners)
  {
    const Point p = this->Mesh.Vertices().Nearest(corner);
    for (int k = 0; k < 3; ++k)
    {
      middle[k] += p[k] / 4;
    }
  }
  const Id point = this->Mesh.AddVertex(middle);
  for (int k = 0; k < 4; ++k)
  {
    Tetrahedron t = corners;
    t[k] = point;
    if (this->Mesh.Vertices().Orient(t[0], t[1], t[2], t[3]) <= 0)
    {
      this->Mesh.RemoveLastVertex();
      return None;
    }
  }
  this->Mesh.SplitCell(cell, point);
  return point;
}

void MeshWithFacets::FlipAtRandom(std::mt19937& random, int tries)
{
  const FlipTarget nothing(this->Mesh);
  for (int k = 0; k < tries; ++k)
  {
    const std::vector<Id> cells = FiniteCells(this->Mesh);
    const Id cell = cells[random() % cells.size()];
    const int i = static_cast<int>(random() % 4);
    const int j = static_cast<int>(i + 1 + random() % 3) % 4;
    if (random() % 2 == 0)
    {
      RemoveFace(*this, cell, i, nothing, AnyFlip);
    }
    else
    {
      const Tetrahedron corners = CellAt(this->Mesh, cell).Corners;
      RemoveEdge(*this, corners[i], corners[j], cell, nothing, AnyFlip);
    }
  }
}

MeshWithFacets RandomMeshWithFacets(
  unsigned seed, int points, unsigned facesPerFacet, WorkBudget& work)
{
  std::mt19937 random(seed);
  FlippableMesh mesh = DelaunayMesh(AnyPoints(seed, points), work);
  std::vector<Triangle> facets;
  for (const Id id : FiniteCells(mesh))
  {
    const FlippableCell& cell = CellAt(mesh, id);
    for (int k = 0; k < 4; ++k)
    {
      const bool isFirst = mesh.IsInfinite(cell.Neighbors[k]) || id < cell.Neighbors[k];
      if (isFirst && random() % facesPerFacet == 0)
      {
        const Tetrahedron& t = cell.Corners;
        facets.push_back({ { t[(k + 1) % 4], t[(k + 2) % 4], t[(k + 3) % 4] } });
      }
    }
  }
  return MeshWithFacets(std::move(mesh), std::move(facets));
}

std::vector<Triangle> FacetsThatDoNotMeet(
  const std::vector<Point>& points, std::mt19937& random, int tries)
{
  std::vector<Triangle> facets;
  const auto any = [&]() { return static_cast<Id>(random() % points.size()); };
  for (int k = 0; k < tries; ++k)
  {
    const Triangle t = { { any(), any(), any() } };
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
    {
      continue;
    }
    const Vector a = testmeshes::Exact(points[t[0]]);
    const Vector normal = testmeshes::Cross(testmeshes::Minus(testmeshes::Exact(points[t[1]]), a),
      testmeshes::Minus(testmeshes::Exact(points[t[2]]), a));
    bool isFree = testmeshes::Dot(normal, normal) != 0;
    for (Id p = 0; isFree && p < static_cast<Id>(points.size()); ++p)
    {
      isFree = !testmeshes::LiesWithinByClipping(points, t, p);
    }
    for (std::size_t f = 0; isFree && f < facets.size(); ++f)
    {
      isFree = !testmeshes::MeetBeyondSharedByClipping(points, facets[f], t);
    }
    if (isFree)
    {
      facets.push_back(t);
    }
  }
  return facets;
}
std::vector<Id> FiniteCells(const FlippableMesh& mesh)
{
  std::vector<Id> cells;
  for (Id cell = 0; cell < NumberOfCells(mesh); ++cell)
  {
    if (!mesh.IsDead(cell) && !mesh.IsInfinite(cell))
    {
      cells.push_back(cell);
    }
  }
  return cells;
}
} // namespace testflips
