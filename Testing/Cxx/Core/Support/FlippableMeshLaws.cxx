// SPDX-License-Identifier: GPL-3.0-or-later
#include "Support/FlippableMeshLaws.h"

#include "Common/SortedTriangle.h"

#include <CGAL/Gmpq.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace testflips
{
namespace
{
using testmeshes::Clip;
using testmeshes::Cross;
using testmeshes::Dot;
using testmeshes::Exact;
using testmeshes::Minus;

using Lines = std::vector<std::string>;
using Edge = std::array<Id, 2>;

/** How far the doubles of a vertex may be from its place, relative to its size. */
constexpr double RoundingErrors = 0x1p-50;

template <typename... Parts>
void Add(Lines& lines, const Parts&... parts)
{
  std::ostringstream line;
  (line << ... << parts);
  lines.push_back(line.str());
}

template <std::size_t N>
std::array<Id, N> Sorted(std::array<Id, N> ids)
{
  std::sort(ids.begin(), ids.end());
  return ids;
}

Triangle SortedFace(const FlippableCell& cell, int k)
{
  const Tetrahedron& t = cell.Corners;
  return SortedTriangle(Triangle{ { t[(k + 1) % 4], t[(k + 2) % 4], t[(k + 3) % 4] } }).Points;
}

int CornerOf(const FlippableCell& cell, Id vertex)
{
  const auto at = std::find(cell.Corners.begin(), cell.Corners.end(), vertex);
  return at == cell.Corners.end() ? -1 : static_cast<int>(at - cell.Corners.begin());
}

bool Has(const FlippableCell& cell, Id vertex)
{
  return CornerOf(cell, vertex) >= 0;
}

/** The index of the neighbor's face that is face k of a cell, -1 for none. */
int MirrorOf(const MeshRecord& mesh, Id cell, int k)
{
  const Triangle face = SortedFace(mesh.Cells[cell], k);
  const FlippableCell& neighbor = mesh.Cells[mesh.Cells[cell].Neighbors[k]];
  for (int j = 0; j < 4; ++j)
  {
    if (neighbor.Neighbors[j] == cell && SortedFace(neighbor, j) == face)
    {
      return j;
    }
  }
  return -1;
}

// --- Exact places --------------------------------------------------------------------------------

Rational ToRational(const DyadicNumber& x)
{
  std::ostringstream text;
  text << static_cast<CGAL::Gmpq>(x);
  return Rational(text.str());
}

/** Four vertices with coordinates in doubles that span space. */
Tetrahedron FindFrame(const FlippableMesh& mesh)
{
  std::vector<Id> doubles;
  for (Id v = 0; v < mesh.Vertices().Size(); ++v)
  {
    if (v != mesh.Infinite() && mesh.Vertices().IsDouble(v))
    {
      doubles.push_back(v);
    }
  }
  for (const Id d : doubles)
  {
    for (const Id c : doubles)
    {
      for (const Id b : doubles)
      {
        if (mesh.Vertices().Orient(doubles[0], b, c, d) > 0)
        {
          return { { doubles[0], b, c, d } };
        }
      }
    }
  }
  return { { None, None, None, None } };
}

/** The place that its determinants with the corners of a tetrahedron say. */
Vector PlaceInFrame(const FlippableMesh& mesh, const Tetrahedron& frame, Id vertex)
{
  Vector sum = { Rational(0), Rational(0), Rational(0) };
  Rational weights = 0;
  for (int k = 0; k < 4; ++k)
  {
    Tetrahedron t = frame;
    t[k] = vertex;
    const Rational weight = ToRational(mesh.Vertices().Determinant(t[0], t[1], t[2], t[3]));
    const Vector corner = Exact(mesh.Vertices().Nearest(frame[k]));
    for (int axis = 0; axis < 3; ++axis)
    {
      sum[axis] += weight * corner[axis];
    }
    weights += weight;
  }
  return { Rational(sum[0] / weights), Rational(sum[1] / weights), Rational(sum[2] / weights) };
}
} // namespace

MeshRecord::MeshRecord(const FlippableMesh& mesh)
  : Infinite(mesh.Infinite())
{
  for (Id cell = 0; cell < NumberOfCells(mesh); ++cell)
  {
    this->Cells.push_back(CellAt(mesh, cell));
  }
  Tetrahedron frame = { { None, None, None, None } };
  std::vector<Id> star;
  for (Id vertex = 0; vertex < mesh.Vertices().Size(); ++vertex)
  {
    star.clear();
    mesh.Star(vertex, star);
    this->CellOf.push_back(star.empty() ? None : star[0]);
    if (mesh.Vertices().IsDouble(vertex))
    {
      this->Places.push_back(Exact(mesh.Vertices().Nearest(vertex)));
      continue;
    }
    frame = frame[0] == None ? FindFrame(mesh) : frame;
    this->Places.push_back(PlaceInFrame(mesh, frame, vertex));
  }
}

bool MeshRecord::IsInfinite(Id cell) const
{
  return Has(this->Cells[cell], this->Infinite);
}

std::set<Tetrahedron> MeshRecord::FiniteCells() const
{
  std::set<Tetrahedron> cells;
  for (Id cell = 0; cell < static_cast<Id>(this->Cells.size()); ++cell)
  {
    if (!this->IsDead(cell) && !this->IsInfinite(cell))
    {
      cells.insert(Sorted(this->Cells[cell].Corners));
    }
  }
  return cells;
}

Rational SixfoldVolume(const Vector& a, const Vector& b, const Vector& c, const Vector& d)
{
  return Dot(Cross(Minus(b, a), Minus(c, a)), Minus(d, a));
}

namespace
{
Rational SixfoldVolume(const std::vector<Vector>& places, const Tetrahedron& t)
{
  return testflips::SixfoldVolume(places[t[0]], places[t[1]], places[t[2]], places[t[3]]);
}
} // namespace

Rational SixfoldVolume(const MeshRecord& mesh)
{
  Rational volume = 0;
  for (Id cell = 0; cell < static_cast<Id>(mesh.Cells.size()); ++cell)
  {
    if (!mesh.IsDead(cell) && !mesh.IsInfinite(cell))
    {
      volume += SixfoldVolume(mesh.Places, mesh.Cells[cell].Corners);
    }
  }
  return volume;
}

std::map<Id, std::set<Triangle>> FacesOfFacets(const MeshRecord& mesh)
{
  std::map<Id, std::set<Triangle>> faces;
  for (Id id = 0; id < static_cast<Id>(mesh.Cells.size()); ++id)
  {
    const FlippableCell& cell = mesh.Cells[id];
    for (int k = 0; !mesh.IsDead(id) && k < 4; ++k)
    {
      if (cell.Facets[k] != None)
      {
        faces[cell.Facets[k]].insert(SortedFace(cell, k));
      }
    }
  }
  return faces;
}

// --- One mesh ------------------------------------------------------------------------------------

namespace
{
void CheckCorners(const MeshRecord& mesh, Id id, Lines& lines)
{
  const Tetrahedron t = Sorted(mesh.Cells[id].Corners);
  if (t[0] < 0 || t[3] >= static_cast<Id>(mesh.Places.size()) ||
    std::adjacent_find(t.begin(), t.end()) != t.end())
  {
    Add(lines, "corners: cell ", id, " has ", t[0], ' ', t[1], ' ', t[2], ' ', t[3]);
  }
}

void CheckNeighbors(const MeshRecord& mesh, Id id, Lines& lines)
{
  for (int k = 0; k < 4; ++k)
  {
    const Id neighbor = mesh.Cells[id].Neighbors[k];
    if (neighbor < 0 || neighbor >= static_cast<Id>(mesh.Cells.size()) || neighbor == id ||
      mesh.IsDead(neighbor) || MirrorOf(mesh, id, k) < 0)
    {
      Add(lines, "neighbors: cell ", id, " names ", neighbor, " across from corner ", k);
    }
  }
}

void CheckFaces(const MeshRecord& mesh, const std::vector<Id>& live, Lines& lines)
{
  std::map<Triangle, int> cells;
  for (const Id id : live)
  {
    for (int k = 0; k < 4; ++k)
    {
      ++cells[SortedFace(mesh.Cells[id], k)];
    }
  }
  for (const auto& [face, count] : cells)
  {
    if (count != 2)
    {
      Add(lines, "faces: ", face[0], ' ', face[1], ' ', face[2], " is of ", count, " cells");
    }
  }
}

/** The corners of an infinite cell with another vertex in the place of the infinite one. */
Tetrahedron Closed(const MeshRecord& mesh, Id infinite, Id vertex)
{
  Tetrahedron t = mesh.Cells[infinite].Corners;
  std::replace(t.begin(), t.end(), mesh.Infinite, vertex);
  return t;
}

Id ApexBehind(const MeshRecord& mesh, Id cell, int k)
{
  return mesh.Cells[mesh.Cells[cell].Neighbors[k]].Corners[MirrorOf(mesh, cell, k)];
}

/** A closed surface that is nowhere reflex is the boundary of its convex hull. */
void CheckHull(const MeshRecord& mesh, Id id, Lines& lines)
{
  const FlippableCell& cell = mesh.Cells[id];
  for (int k = 0; k < 4; ++k)
  {
    const Id apex = ApexBehind(mesh, id, k);
    const bool isFinite = cell.Corners[k] == mesh.Infinite;
    if (isFinite && apex == mesh.Infinite)
    {
      Add(lines, "hull: cell ", id, " is infinite, and so is the one behind it");
      continue;
    }
    const Rational volume = SixfoldVolume(mesh.Places, Closed(mesh, id, apex));
    if (isFinite ? volume >= 0 : volume > 0)
    {
      Add(lines, "hull: of cell ", id, " the vertex ", apex, " is beyond");
    }
  }
}

/** Cells are positive and fill the pyramids between the hull's faces and one vertex. */
void CheckVolume(const MeshRecord& mesh, const std::vector<Id>& live, Lines& lines)
{
  const Tetrahedron& any = mesh.Cells[live[0]].Corners;
  const Id apex = any[0] == mesh.Infinite ? any[1] : any[0];
  Rational inside = 0;
  Rational enclosed = 0;
  for (const Id id : live)
  {
    if (mesh.IsInfinite(id))
    {
      enclosed -= SixfoldVolume(mesh.Places, Closed(mesh, id, apex));
      continue;
    }
    const Rational volume = SixfoldVolume(mesh.Places, mesh.Cells[id].Corners);
    if (volume <= 0)
    {
      Add(lines, "orientation: cell ", id, " is ", volume == 0 ? "flat" : "turned over");
    }
    inside += volume;
  }
  if (inside != enclosed)
  {
    Add(
      lines, "volume: the cells have ", Rational(inside / enclosed), " of what the hull encloses");
  }
}

/** How many cells around a vertex hang together with the one that it names. */
int SizeOfStar(const MeshRecord& mesh, Id vertex)
{
  std::set<Id> known = { mesh.CellOf[vertex] };
  std::vector<Id> cells(known.begin(), known.end());
  for (std::size_t next = 0; next < cells.size(); ++next)
  {
    const FlippableCell& cell = mesh.Cells[cells[next]];
    for (int k = 0; k < 4; ++k)
    {
      if (cell.Corners[k] != vertex && known.insert(cell.Neighbors[k]).second)
      {
        cells.push_back(cell.Neighbors[k]);
      }
    }
  }
  return static_cast<int>(cells.size());
}

void CheckVertices(const MeshRecord& mesh, const std::vector<Id>& live, Lines& lines)
{
  std::vector<int> cells(mesh.Places.size(), 0);
  for (const Id id : live)
  {
    for (const Id corner : mesh.Cells[id].Corners)
    {
      ++cells[corner];
    }
  }
  for (Id vertex = 0; vertex < static_cast<Id>(mesh.Places.size()); ++vertex)
  {
    const Id cell = mesh.CellOf[vertex];
    const bool isRight = cell == None ? cells[vertex] == 0
                                      : !mesh.IsDead(cell) && Has(mesh.Cells[cell], vertex) &&
        SizeOfStar(mesh, vertex) == cells[vertex];
    if (!isRight)
    {
      Add(lines, "vertices: ", vertex, " names ", cell, ", and ", cells[vertex], " cells have it");
    }
  }
}

void CheckFacets(const MeshRecord& mesh, Id id, Lines& lines)
{
  for (int k = 0; k < 4; ++k)
  {
    const FlippableCell& neighbor = mesh.Cells[mesh.Cells[id].Neighbors[k]];
    if (neighbor.Facets[MirrorOf(mesh, id, k)] != mesh.Cells[id].Facets[k])
    {
      Add(lines, "facets: cell ", id, " has ", mesh.Cells[id].Facets[k], " across from corner ", k,
        ", and its neighbor has not");
    }
  }
}

void CheckEuler(const MeshRecord& mesh, const std::vector<Id>& live, Lines& lines)
{
  std::set<Id> vertices;
  std::set<Edge> edges;
  for (const Id id : live)
  {
    const Tetrahedron t = Sorted(mesh.Cells[id].Corners);
    vertices.insert(t.begin(), t.end());
    for (int i = 0; i < 4; ++i)
    {
      for (int j = 0; j < i; ++j)
      {
        edges.insert({ { t[j], t[i] } });
      }
    }
  }
  // Four faces of each cell, each of two cells.
  const auto characteristic = static_cast<std::ptrdiff_t>(vertices.size() + live.size()) -
    static_cast<std::ptrdiff_t>(edges.size());
  if (characteristic != 0)
  {
    Add(lines, "Euler: the characteristic is ", characteristic);
  }
}
} // namespace

std::vector<std::string> Violations(const MeshRecord& mesh)
{
  Lines lines;
  std::vector<Id> live;
  for (Id id = 0; id < static_cast<Id>(mesh.Cells.size()); ++id)
  {
    if (!mesh.IsDead(id))
    {
      live.push_back(id);
    }
  }
  for (const Id id : live)
  {
    CheckCorners(mesh, id, lines);
  }
  for (std::size_t k = 0; lines.empty() && k < live.size(); ++k)
  {
    CheckNeighbors(mesh, live[k], lines);
  }
  CheckFaces(mesh, live, lines);
  if (!lines.empty())
  {
    return lines;
  }
  for (const Id id : live)
  {
    CheckFacets(mesh, id, lines);
    if (mesh.IsInfinite(id))
    {
      CheckHull(mesh, id, lines);
    }
  }
  CheckVolume(mesh, live, lines);
  CheckVertices(mesh, live, lines);
  CheckEuler(mesh, live, lines);
  return lines;
}

// --- A mesh and what it says ---------------------------------------------------------------------

namespace
{
void CheckAccessors(const FlippableMesh& mesh, const MeshRecord& record, Id id, Lines& lines)
{
  for (int k = 0; k < 4; ++k)
  {
    const int mirror = MirrorOf(record, id, k);
    if (mesh.MirrorIndex(id, k) != mirror ||
      mesh.Opposite(id, k) != record.Cells[record.Cells[id].Neighbors[k]].Corners[mirror])
    {
      Add(lines, "accessors: what is across from corner ", k, " of cell ", id);
    }
  }
}

void CheckStar(const FlippableMesh& mesh, const MeshRecord& record, Id vertex, Lines& lines)
{
  std::vector<Id> star;
  mesh.Star(vertex, star);
  const std::set<Id> cells(star.begin(), star.end());
  const bool isAround = std::all_of(star.begin(), star.end(),
    [&](Id cell) { return !record.IsDead(cell) && Has(record.Cells[cell], vertex); });
  const std::size_t size =
    record.CellOf[vertex] == None ? 0 : static_cast<std::size_t>(SizeOfStar(record, vertex));
  if (!isAround || cells.size() != star.size() || cells.size() != size ||
    mesh.HasVertex(vertex) != (size > 0))
  {
    Add(lines, "accessors: the star of vertex ", vertex);
  }
}

void CheckPlace(const FlippableMesh& mesh, const MeshRecord& record, Id vertex, Lines& lines)
{
  const Vector nearest = Exact(mesh.Vertices().Nearest(vertex));
  for (int axis = 0; axis < 3; ++axis)
  {
    const Rational& exact = record.Places[vertex][axis];
    const Rational error = nearest[axis] - exact;
    if (error * error > Rational(RoundingErrors * RoundingErrors) * exact * exact)
    {
      Add(lines, "places: vertex ", vertex, " is not beside its nearest doubles");
    }
  }
}
} // namespace

std::vector<std::string> FlippableMeshViolations(const FlippableMesh& mesh)
{
  const MeshRecord record(mesh);
  Lines lines = Violations(record);
  if (!lines.empty())
  {
    return lines;
  }
  for (Id id = 0; id < static_cast<Id>(record.Cells.size()); ++id)
  {
    if (mesh.IsDead(id) != record.IsDead(id))
    {
      Add(lines, "accessors: whether cell ", id, " is dead");
    }
    if (record.IsDead(id))
    {
      continue;
    }
    CheckAccessors(mesh, record, id, lines);
    const Tetrahedron& t = record.Cells[id].Corners;
    if (!record.IsInfinite(id) && mesh.Vertices().Orient(t[0], t[1], t[2], t[3]) != 1)
    {
      Add(lines, "predicates: the orientation of cell ", id);
    }
  }
  for (Id vertex = 0; vertex < mesh.Vertices().Size(); ++vertex)
  {
    CheckStar(mesh, record, vertex, lines);
    CheckPlace(mesh, record, vertex, lines);
  }
  return lines;
}

// --- Facets and segments -------------------------------------------------------------------------

namespace
{
std::vector<Vector> Polygon(const std::vector<Vector>& places, const Triangle& t)
{
  return { places[t[0]], places[t[1]], places[t[2]] };
}

Vector NormalOf(const std::vector<Vector>& polygon)
{
  return Cross(Minus(polygon[1], polygon[0]), Minus(polygon[2], polygon[0]));
}

/** The area of a convex polygon times twice the length of a normal of its plane. */
Rational AreaAlong(const std::vector<Vector>& polygon, const Vector& normal)
{
  Rational area = 0;
  for (std::size_t k = 2; k < polygon.size(); ++k)
  {
    area += Dot(Cross(Minus(polygon[k - 1], polygon[0]), Minus(polygon[k], polygon[0])), normal);
  }
  return area < 0 ? Rational(-area) : area;
}

/** The part of a polygon in a triangle, in one plane. */
std::vector<Vector> PartWithin(
  std::vector<Vector> polygon, const std::vector<Vector>& triangle, const Vector& normal)
{
  for (int k = 0; k < 3; ++k)
  {
    const Vector along = Minus(triangle[(k + 1) % 3], triangle[k]);
    Vector inward = Cross(normal, along);
    if (Dot(inward, Minus(triangle[(k + 2) % 3], triangle[k])) < 0)
    {
      inward = Minus({ Rational(0), Rational(0), Rational(0) }, inward);
    }
    polygon = Clip(polygon, triangle[k], inward);
  }
  return polygon;
}
} // namespace

bool CoverTheSame(const std::vector<Vector>& places, const std::set<Triangle>& some,
  const std::set<Triangle>& others)
{
  if (some.empty() || others.empty())
  {
    return some.empty() && others.empty();
  }
  const std::vector<Vector> first = Polygon(places, *some.begin());
  const Vector normal = NormalOf(first);
  Rational area = 0;
  Rational otherArea = 0;
  Rational shared = 0;
  for (const std::set<Triangle>* triangles : { &some, &others })
  {
    for (const Triangle& t : *triangles)
    {
      for (const Id corner : t)
      {
        if (Dot(Minus(places[corner], first[0]), normal) != 0)
        {
          return false;
        }
      }
      (triangles == &some ? area : otherArea) += AreaAlong(Polygon(places, t), normal);
    }
  }
  for (const Triangle& s : some)
  {
    for (const Triangle& t : others)
    {
      shared += AreaAlong(PartWithin(Polygon(places, s), Polygon(places, t), normal), normal);
    }
  }
  return area == otherArea && area == shared;
}

std::vector<std::string> ChangeViolations(
  const MeshRecord& before, const MeshRecord& after, FacetsKept kept)
{
  Lines lines;
  std::map<Id, std::set<Triangle>> old = FacesOfFacets(before);
  std::map<Id, std::set<Triangle>> now = FacesOfFacets(after);
  for (const auto& facet : now)
  {
    old[facet.first]; // with no faces where it was not there
  }
  for (const auto& [facet, faces] : old)
  {
    const bool isKept = faces == now[facet] ||
      (kept == FacetsKept::AsAreas && CoverTheSame(after.Places, faces, now[facet]));
    if (!isKept)
    {
      Add(lines, "kept facets: ", facet, " had ", faces.size(), " faces and has ",
        now[facet].size(), " others");
    }
  }
  if (SixfoldVolume(before) != SixfoldVolume(after))
  {
    Add(lines, "kept volume: it was another");
  }
  return lines;
}

std::vector<std::string> ConstraintViolations(
  const FlippableMesh& mesh, const SegmentTable& segments, const std::vector<Triangle>& facets)
{
  Lines lines;
  for (const auto& [facet, faces] : FacesOfFacets(MeshRecord(mesh)))
  {
    std::set<Edge> open;
    const auto toggle = [&open](Id u, Id v)
    {
      const Edge edge = Sorted(Edge{ { u, v } });
      if (!open.insert(edge).second)
      {
        open.erase(edge);
      }
    };
    for (int k = 0; k < 3; ++k)
    {
      const Id segment = segments.OfFacet(facet, k);
      const std::vector<Id> path = segments.Path(segment);
      const Edge ends = Sorted(Edge{ { facets[facet][k], facets[facet][(k + 1) % 3] } });
      if (Sorted(Edge{ { path.front(), path.back() } }) != ends)
      {
        Add(lines, "segments: edge ", k, " of facet ", facet, " has other ends");
      }
      for (std::size_t j = 1; j < path.size(); ++j)
      {
        toggle(path[j - 1], path[j]);
        if (mesh.FindEdge(path[j - 1], path[j]) == None ||
          segments.Find(path[j], path[j - 1]) != segment)
        {
          Add(lines, "segments: ", path[j - 1], ' ', path[j], " is no edge of facet ", facet);
        }
      }
    }
    for (const Triangle& face : faces)
    {
      for (int k = 0; k < 3; ++k)
      {
        toggle(face[k], face[(k + 1) % 3]);
      }
    }
    if (!open.empty())
    {
      Add(lines, "kept facets: ", facet, " is open");
    }
  }
  return lines;
}

std::vector<std::string> Differences(const MeshRecord& a, const MeshRecord& b)
{
  Lines lines;
  if (a.Cells.size() != b.Cells.size() || a.Places.size() != b.Places.size())
  {
    Add(lines, "sizes: ", a.Cells.size(), " cells of ", a.Places.size(), " vertices, and ",
      b.Cells.size(), " of ", b.Places.size());
    return lines;
  }
  for (Id id = 0; id < static_cast<Id>(a.Cells.size()); ++id)
  {
    const FlippableCell& x = a.Cells[id];
    const FlippableCell& y = b.Cells[id];
    if (a.IsDead(id) != b.IsDead(id) ||
      (!a.IsDead(id) &&
        (x.Corners != y.Corners || x.Neighbors != y.Neighbors || x.Facets != y.Facets)))
    {
      Add(lines, "cells: ", id);
    }
  }
  for (std::size_t vertex = 0; vertex < a.Places.size(); ++vertex)
  {
    if (a.CellOf[vertex] != b.CellOf[vertex] || a.Places[vertex] != b.Places[vertex])
    {
      Add(lines, "vertices: ", vertex);
    }
  }
  return lines;
}

// --- Expectations --------------------------------------------------------------------------------

namespace
{
void ExpectNone(const Lines& lines)
{
  for (const std::string& line : lines)
  {
    ADD_FAILURE() << line;
  }
}
} // namespace

void ExpectFlippableMeshLaws(const FlippableMesh& mesh)
{
  ExpectNone(FlippableMeshViolations(mesh));
}

void ExpectFlippableMeshLaws(const FlippableMesh& mesh, const MeshRecord& before, FacetsKept kept)
{
  ExpectFlippableMeshLaws(mesh);
  ExpectNone(ChangeViolations(before, MeshRecord(mesh), kept));
}

void ExpectUnchanged(const FlippableMesh& mesh, const MeshRecord& before)
{
  ExpectNone(Differences(before, MeshRecord(mesh)));
}
} // namespace testflips
