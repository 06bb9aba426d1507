// SPDX-License-Identifier: GPL-3.0-or-later
#include "Support/MeshLaws.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>

namespace testmeshes
{
namespace
{
using namespace insideout;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Number = CGAL::Exact_rational;
using Edge = std::pair<Id, Id>;

Kernel::Point_3 At(const TetrahedralMesh& mesh, Id p)
{
  return { mesh.Points[p][0], mesh.Points[p][1], mesh.Points[p][2] };
}

/** Six times the signed volume of a tetrahedron, without error. */
Number Determinant(const Point& a, const Point& b, const Point& c, const Point& d)
{
  std::array<std::array<Number, 3>, 3> m;
  for (int k = 0; k < 3; ++k)
  {
    m[0][k] = Number(b[k]) - Number(a[k]);
    m[1][k] = Number(c[k]) - Number(a[k]);
    m[2][k] = Number(d[k]) - Number(a[k]);
  }
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
    m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
    m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

Number SixfoldVolumeOfHull(const std::vector<Point>& points)
{
  std::vector<Kernel::Point_3> input;
  for (const Point& p : points)
  {
    input.emplace_back(p[0], p[1], p[2]);
  }
  CGAL::Surface_mesh<Kernel::Point_3> hull;
  CGAL::convex_hull_3(input.begin(), input.end(), hull);
  Number volume = 0;
  for (const auto face : hull.faces())
  {
    std::vector<Point> corners;
    for (const auto vertex : CGAL::vertices_around_face(hull.halfedge(face), hull))
    {
      const Kernel::Point_3& p = hull.point(vertex);
      corners.push_back({ { p.x(), p.y(), p.z() } });
    }
    for (std::size_t k = 2; k < corners.size(); ++k)
    {
      volume += Determinant(points[0], corners[0], corners[k - 1], corners[k]);
    }
  }
  return volume;
}

Triangle FaceOf(const TetrahedralMesh& mesh, Id cell, int face)
{
  const std::array<int, 3>& corners = TetrahedronFaces[face];
  const Tetrahedron& t = mesh.Cells[cell];
  return { { t[corners[0]], t[corners[1]], t[corners[2]] } };
}

Id ApexOf(const TetrahedralMesh& mesh, Id cell, int face)
{
  const Triangle corners = FaceOf(mesh, cell, face);
  for (const Id p : mesh.Cells[cell])
  {
    if (std::find(corners.begin(), corners.end(), p) == corners.end())
    {
      return p;
    }
  }
  return None;
}

template <std::size_t N>
std::array<Id, N> Sorted(std::array<Id, N> ids)
{
  std::sort(ids.begin(), ids.end());
  return ids;
}

void ExpectPoints(const FacetComplex& surface, const TetrahedralMesh& mesh)
{
  ASSERT_EQ(mesh.Points.size(), surface.Points.size() + mesh.NumberOfSteinerPoints);
  ASSERT_EQ(mesh.Origins.size(), mesh.Points.size());
  ASSERT_EQ(
    std::memcmp(mesh.Points.data(), surface.Points.data(), surface.Points.size() * sizeof(Point)),
    0);
  Id onSurface = 0;
  for (std::size_t p = 0; p < mesh.Points.size(); ++p)
  {
    const PointOrigin& origin = mesh.Origins[p];
    if (p < surface.Points.size())
    {
      EXPECT_EQ(origin.Points, surface.Origins[p].Points);
      EXPECT_EQ(origin.Weights, surface.Origins[p].Weights);
    }
    else if (origin.Points[0] != None)
    {
      ++onSurface;
      EXPECT_NEAR(origin.Weights[0] + origin.Weights[1] + origin.Weights[2], 1, 1e-15);
      EXPECT_GE(*std::min_element(origin.Weights.begin(), origin.Weights.end()), 0);
    }
  }
  EXPECT_EQ(onSurface, mesh.NumberOfSurfaceSteinerPoints);
}

void ExpectVolumes(const TetrahedralMesh& mesh)
{
  Number total = 0;
  for (const Tetrahedron& t : mesh.Cells)
  {
    const Number volume =
      Determinant(mesh.Points[t[0]], mesh.Points[t[1]], mesh.Points[t[2]], mesh.Points[t[3]]);
    ASSERT_GT(volume, 0);
    total += volume;
  }
  EXPECT_TRUE(total == SixfoldVolumeOfHull(mesh.Points)) << "cells overlap or leave gaps";
}

void ExpectNeighbors(const TetrahedralMesh& mesh)
{
  std::map<Triangle, std::vector<Id>> cellsOfFaces;
  std::map<Edge, int> hullEdges;
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      cellsOfFaces[Sorted(FaceOf(mesh, c, k))].push_back(c);
    }
  }
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      const Triangle face = FaceOf(mesh, c, k);
      const std::vector<Id>& cells = cellsOfFaces[Sorted(face)];
      ASSERT_LE(cells.size(), 2u);
      const Id expected = cells.size() == 1 ? None : cells[0] == c ? cells[1] : cells[0];
      ASSERT_EQ(mesh.Neighbors[c][k], expected);
      for (int e = 0; expected == None && e < 3; ++e)
      {
        const Id from = face[e];
        const Id to = face[(e + 1) % 3];
        hullEdges[std::minmax(from, to)] += from < to ? 1 : -1;
      }
    }
  }
  for (const auto& edge : hullEdges)
  {
    ASSERT_EQ(edge.second, 0) << "the hull is open";
  }
}

/** A face that a facet lies on. */
struct PlacedFace
{
  Id Cell;
  int Face;
};

/** On a facet in pieces, which has rounded points on it, a nearby apex may be on either side. */
void ExpectSides(const FacetComplex& surface, const TetrahedralMesh& mesh, Id facet,
  const std::vector<PlacedFace>& faces)
{
  const Triangle& corners = surface.Facets[facet];
  for (const PlacedFace& face : faces)
  {
    const bool isWhole = Sorted(FaceOf(mesh, face.Cell, face.Face)) == Sorted(corners);
    const Id apex = ApexOf(mesh, face.Cell, face.Face);
    const CGAL::Orientation side = CGAL::orientation(
      At(mesh, corners[0]), At(mesh, corners[1]), At(mesh, corners[2]), At(mesh, apex));
    if (isWhole)
    {
      ASSERT_EQ(static_cast<int>(mesh.FacetSides[face.Cell][face.Face]), -static_cast<int>(side));
    }
    const Id neighbor = mesh.Neighbors[face.Cell][face.Face];
    if (neighbor != None)
    {
      const Triangle shared = Sorted(FaceOf(mesh, face.Cell, face.Face));
      int k = 0;
      while (Sorted(FaceOf(mesh, neighbor, k)) != shared)
      {
        ++k;
      }
      ASSERT_EQ(mesh.Facets[neighbor][k], facet);
      ASSERT_EQ(mesh.FacetSides[neighbor][k], -mesh.FacetSides[face.Cell][face.Face]);
    }
  }
}

/** How far points that lie on a facet or its edges may be beside it, of the largest coordinate. */
constexpr double RoundingTolerance = 1e-12;

double LargestCoordinate(const std::vector<Point>& points)
{
  double largest = 0;
  for (const Point& point : points)
  {
    for (const double x : point)
    {
      largest = std::max(largest, std::abs(x));
    }
  }
  return largest;
}

/** The pieces of a facet, each once, turned as the facet is. */
std::vector<Triangle> PiecesOf(const TetrahedralMesh& mesh, const std::vector<PlacedFace>& faces)
{
  std::vector<Triangle> pieces;
  std::set<Triangle> known;
  for (const PlacedFace& face : faces)
  {
    Triangle piece = FaceOf(mesh, face.Cell, face.Face);
    if (known.insert(Sorted(piece)).second)
    {
      if (mesh.FacetSides[face.Cell][face.Face] < 0)
      {
        std::swap(piece[0], piece[1]);
      }
      pieces.push_back(piece);
    }
  }
  return pieces;
}

/** The pieces' edges, without those that two have in opposite directions. */
std::map<Id, Id> BoundaryOf(const std::vector<Triangle>& pieces)
{
  std::set<Edge> edges;
  for (const Triangle& piece : pieces)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Edge edge(piece[k], piece[(k + 1) % 3]);
      if (edges.erase({ edge.second, edge.first }) == 0)
      {
        EXPECT_TRUE(edges.insert(edge).second) << "two pieces overlap or are turned differently";
      }
    }
  }
  std::map<Id, Id> next;
  for (const Edge& edge : edges)
  {
    EXPECT_TRUE(next.insert(edge).second) << "the boundary passes a point twice";
  }
  return next;
}

using Vector = std::array<Number, 3>;

Vector Difference(const Point& a, const Point& b)
{
  return { { Number(a[0]) - Number(b[0]), Number(a[1]) - Number(b[1]),
    Number(a[2]) - Number(b[2]) } };
}

Vector Cross(const Vector& a, const Vector& b)
{
  return { { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] } };
}

Number SquaredLength(const Vector& a)
{
  return a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
}

/** Whether a point is at most so far from the line through two others, without error. */
bool IsNearLine(const TetrahedralMesh& mesh, Id a, Id b, Id p, double distance)
{
  const Vector along = Difference(mesh.Points[b], mesh.Points[a]);
  const Vector to = Difference(mesh.Points[p], mesh.Points[a]);
  return SquaredLength(Cross(along, to)) <=
    Number(distance) * Number(distance) * SquaredLength(along);
}

/** Whether a point is at most so far from the plane of a facet, without error. */
bool IsNearPlane(const TetrahedralMesh& mesh, const Triangle& facet, Id p, double distance)
{
  const std::vector<Point>& points = mesh.Points;
  const Number volume =
    Determinant(points[facet[0]], points[facet[1]], points[facet[2]], points[p]);
  const Vector normal = Cross(
    Difference(points[facet[1]], points[facet[0]]), Difference(points[facet[2]], points[facet[0]]));
  return volume * volume <= Number(distance) * Number(distance) * SquaredLength(normal);
}

/**
 * The pieces are one disk, by counting: their boundary is one closed line that passes the facet's
 * corners in order. Between them are input points, which are exactly on the facet, or Steiner
 * points, which are off it by rounding errors.
 */
void ExpectUnion(const FacetComplex& surface, const TetrahedralMesh& mesh, Id facet,
  const std::vector<PlacedFace>& faces)
{
  const Triangle& corners = surface.Facets[facet];
  const std::vector<Triangle> pieces = PiecesOf(mesh, faces);
  if (pieces.size() == 1)
  {
    EXPECT_EQ(Sorted(pieces[0]), Sorted(corners));
    return;
  }
  const std::map<Id, Id> next = BoundaryOf(pieces);
  const double rounding = RoundingTolerance * LargestCoordinate(surface.Points);
  const auto toleranceAt = [&](Id p)
  { return p < static_cast<Id>(surface.Points.size()) ? 0 : rounding; };
  std::size_t numberOfEdges = 0;
  for (int k = 0; k < 3; ++k)
  {
    Id p = corners[k];
    while (p != corners[(k + 1) % 3] && numberOfEdges < next.size())
    {
      ASSERT_TRUE(next.count(p) > 0) << "facet " << facet << " is open";
      p = next.at(p);
      ++numberOfEdges;
      if (p != corners[(k + 1) % 3])
      {
        EXPECT_TRUE(IsNearLine(mesh, corners[k], corners[(k + 1) % 3], p, toleranceAt(p)))
          << "facet " << facet;
      }
    }
    ASSERT_EQ(p, corners[(k + 1) % 3]) << "facet " << facet;
  }
  EXPECT_EQ(numberOfEdges, next.size()) << "facet " << facet << " has a hole";

  std::set<Id> points;
  for (const Triangle& piece : pieces)
  {
    points.insert(piece.begin(), piece.end());
  }
  for (const Id p : points)
  {
    EXPECT_TRUE(IsNearPlane(mesh, corners, p, toleranceAt(p))) << "facet " << facet;
  }
  // Euler's formula for a disk of F triangles with B boundary edges: V = (F + B) / 2 + 1.
  EXPECT_EQ(2 * points.size(), pieces.size() + next.size() + 2) << "facet " << facet;
}

void ExpectFacets(const FacetComplex& surface, const TetrahedralMesh& mesh)
{
  ASSERT_EQ(mesh.Facets.size(), mesh.Cells.size());
  ASSERT_EQ(mesh.FacetSides.size(), mesh.Cells.size());
  std::vector<std::vector<PlacedFace>> faces(surface.Facets.size());
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      const Id facet = mesh.Facets[c][k];
      ASSERT_EQ(mesh.FacetSides[c][k] == 0, facet == None);
      if (facet != None)
      {
        faces[facet].push_back({ c, k });
      }
    }
  }
  const std::set<Id> lost(mesh.LostFacets.begin(), mesh.LostFacets.end());
  ASSERT_TRUE(std::is_sorted(mesh.LostFacets.begin(), mesh.LostFacets.end()));
  for (Id facet = 0; facet < surface.NumberOfFacets(); ++facet)
  {
    if (facet >= surface.NumberOfConstraints || lost.count(facet))
    {
      EXPECT_TRUE(faces[facet].empty()) << "facet " << facet;
      continue;
    }
    ASSERT_FALSE(faces[facet].empty()) << "facet " << facet;
    ExpectSides(surface, mesh, facet, faces[facet]);
    ExpectUnion(surface, mesh, facet, faces[facet]);
  }
}
} // namespace

void ExpectMeshLaws(const FacetComplex& surface, const TetrahedralMesh& mesh)
{
  ExpectPoints(surface, mesh);
  ExpectVolumes(mesh);
  ExpectNeighbors(mesh);
  ExpectFacets(surface, mesh);
}
} // namespace testmeshes
