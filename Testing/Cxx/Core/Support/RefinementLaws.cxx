// SPDX-License-Identifier: GPL-3.0-or-later
#include "Support/RefinementLaws.h"

#include "Common/Box.h"
#include "Common/DisjointSets.h"
#include "Common/PointPredicates.h"
#include "Common/Vectors.h"
#include "GraphCut/ConnectCells.h"
#include "Resolve/FindIntersections.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace testmeshes
{
using namespace insideout;

namespace
{
/** The places of a face's corners, the least first, in an order that says which way it faces. */
using OrientedFace = std::array<Point, 3>;

OrientedFace FaceAt(const std::vector<Point>& points, const Triangle& face, bool turned)
{
  OrientedFace places = { { points[face[0]], points[face[turned ? 2 : 1]],
    points[face[turned ? 1 : 2]] } };
  std::rotate(places.begin(), std::min_element(places.begin(), places.end()), places.end());
  return places;
}

/** Faces that have no cell of the same region behind them, with that region, seen from outside. */
std::multiset<std::pair<Id, OrientedFace>> FacesOfRegions(const std::vector<Point>& points,
  const std::vector<Tetrahedron>& cells, const std::vector<Id>& regions)
{
  std::multiset<std::pair<Id, OrientedFace>> faces;
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      const Triangle face = FaceOf(cells[c], k);
      const auto twin = faces.find({ regions[c], FaceAt(points, face, true) });
      if (twin != faces.end())
      {
        faces.erase(twin);
      }
      else
      {
        faces.insert({ regions[c], FaceAt(points, face, false) });
      }
    }
  }
  return faces;
}

bool IsIn(const TetrahedralMesh& mesh, Id cell, const Point& place)
{
  for (int k = 0; k < 4; ++k)
  {
    const Triangle f = FaceOf(mesh.Cells[cell], k);
    if (Orient3D(mesh.Points[f[0]], mesh.Points[f[1]], mesh.Points[f[2]], place) > 0)
    {
      return false;
    }
  }
  return true;
}
} // namespace

void ExpectRefinementLaws(
  const TetrahedralMesh& mesh, const std::vector<Id>& regions, const RefinedMesh& refined)
{
  ASSERT_EQ(refined.OriginalCells.size(), refined.Cells.size());
  ASSERT_EQ(refined.OriginalPoints.size(), refined.Points.size());
  ASSERT_EQ(refined.CellsOfPoints.size(), refined.Points.size());
  const std::vector<Id> before = regions.empty() ? std::vector<Id>(mesh.Cells.size(), 0) : regions;
  std::vector<Id> after;
  for (std::size_t c = 0; c < refined.Cells.size(); ++c)
  {
    EXPECT_GT(Orient3D(refined.Points, refined.Cells[c]), 0) << "cell " << c;
    after.push_back(before[refined.OriginalCells[c]]);
  }
  EXPECT_EQ(FacesOfRegions(mesh.Points, mesh.Cells, before),
    FacesOfRegions(refined.Points, refined.Cells, after));
  std::map<Point, Id> pointAt;
  for (std::size_t p = 0; p < mesh.Points.size(); ++p)
  {
    pointAt.insert({ mesh.Points[p], static_cast<Id>(p) });
  }
  for (std::size_t p = 0; p < refined.Points.size(); ++p)
  {
    EXPECT_TRUE(refined.OriginalPoints[p] != None || pointAt.count(refined.Points[p]) == 0)
      << "point " << p << " has not moved";
    if (const Id original = refined.OriginalPoints[p]; original != None)
    {
      EXPECT_EQ(refined.Points[p], mesh.Points[original]);
    }
    EXPECT_TRUE(IsIn(mesh, refined.CellsOfPoints[p], refined.Points[p])) << "point " << p;
  }
}

namespace
{
/** A face of the boundary or between regions, seen from its cell's outside. */
struct SurfaceFace
{
  Triangle Corners;
  Id Region;
  Id Original; ///< of refined ones
};

/** All faces that have no cell of their region behind them. */
std::vector<SurfaceFace> SurfaceFaces(const std::vector<Tetrahedron>& cells,
  const std::vector<Id>& regions, const std::vector<std::array<Id, 4>>* originals)
{
  std::map<Triangle, std::vector<std::pair<Id, int>>> uses;
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      Triangle sorted = FaceOf(cells[c], k);
      std::sort(sorted.begin(), sorted.end());
      uses[sorted].push_back({ static_cast<Id>(c), k });
    }
  }
  std::vector<SurfaceFace> faces;
  for (const auto& [corners, ofCells] : uses)
  {
    EXPECT_LE(ofCells.size(), 2U);
    const bool isInner =
      ofCells.size() == 2 && regions[ofCells[0].first] == regions[ofCells[1].first];
    for (const auto& [c, k] : ofCells)
    {
      if (originals)
      {
        EXPECT_EQ((*originals)[c][k] == None, isInner) << "face " << k << " of cell " << c;
      }
      if (!isInner)
      {
        faces.push_back({ FaceOf(cells[c], k), regions[c], originals ? (*originals)[c][k] : None });
      }
    }
  }
  return faces;
}

std::vector<Id> RegionsAfter(const std::vector<Id>& before, const RefinedMesh& refined)
{
  std::vector<Id> after;
  for (std::size_t c = 0; c < refined.Cells.size(); ++c)
  {
    EXPECT_GT(Orient3D(refined.Points, refined.Cells[c]), 0) << "cell " << c;
    after.push_back(before[refined.OriginalCells[c]]);
  }
  return after;
}

std::map<Id, double> VolumesOf(const std::vector<Point>& points,
  const std::vector<Tetrahedron>& cells, const std::vector<Id>& regions)
{
  std::map<Id, double> volumes;
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    const auto [p, q, r, s] = CornersOf(points, cells[c]);
    volumes[regions[c]] += Determinant(Difference(q, p), Difference(r, p), Difference(s, p)) / 6;
  }
  return volumes;
}

void ExpectNoCrossings(const TetrahedralMesh& mesh, const RefinedMesh& refined)
{
  const auto crossings = [](const std::vector<Point>& points, const std::vector<Tetrahedron>& cells)
  {
    std::vector<Triangle> boundary;
    for (const SurfaceFace& face : SurfaceFaces(cells, std::vector<Id>(cells.size(), 0), nullptr))
    {
      boundary.push_back(face.Corners);
    }
    Monitor monitor;
    return FindIntersections(points, boundary, monitor).size();
  };
  EXPECT_LE(crossings(refined.Points, refined.Cells), crossings(mesh.Points, mesh.Cells));
}

/** Vertices less edges plus faces of all faces of each region. */
std::map<Id, int> EulerCharacteristics(const std::vector<SurfaceFace>& faces)
{
  std::map<Id, std::set<Id>> vertices;
  std::map<Id, std::set<std::pair<Id, Id>>> edges;
  std::map<Id, int> result;
  for (const SurfaceFace& face : faces)
  {
    for (int i = 0; i < 3; ++i)
    {
      const Id p = face.Corners[i];
      const Id q = face.Corners[(i + 1) % 3];
      result[face.Region] += vertices[face.Region].insert(p).second ? 1 : 0;
      result[face.Region] -= edges[face.Region].insert(std::minmax(p, q)).second ? 1 : 0;
    }
    ++result[face.Region];
  }
  return result;
}

/** The least distance of a place from triangles of a region, by many samples of each. */
double DistanceFrom(const Point& place, const std::vector<SurfaceFace>& faces,
  const std::vector<Point>& points, Id region)
{
  double least = std::numeric_limits<double>::infinity();
  for (const SurfaceFace& face : faces)
  {
    const std::array<Point, 3> t = CornersOf(points, face.Corners);
    const Point normal = NormalOf(t[0], t[1], t[2]);
    const double height = Dot(Difference(place, t[0]), normal) / Length(normal);
    if (face.Region != region || std::abs(height) > least)
    {
      continue;
    }
    bool isOver = true;
    for (int k = 0; k < 3; ++k)
    {
      const Point along = Difference(t[(k + 1) % 3], t[k]);
      const Point toPlace = Difference(place, t[k]);
      isOver = isOver && Dot(Cross(along, toPlace), normal) >= 0;
      const double part = std::clamp(Dot(toPlace, along) / Dot(along, along), 0.0, 1.0);
      const Point foot = { { t[k][0] + part * along[0], t[k][1] + part * along[1],
        t[k][2] + part * along[2] } };
      least = std::min(least, Distance(place, foot));
    }
    least = isOver ? std::min(least, std::abs(height)) : least;
  }
  return least;
}

Point WithinFace(const std::array<Point, 3>& t, double u, double v)
{
  Point place;
  for (int k = 0; k < 3; ++k)
  {
    place[k] = t[0][k] + u * (t[1][k] - t[0][k]) + v * (t[2][k] - t[0][k]);
  }
  return place;
}
} // namespace

namespace
{
/** Faces of a region, joined where they share an edge with no third one and lie in one plane: per
 * face, as 4 * cell + face, one of its patch. */
std::map<Id, Id> PatchesOf(
  const TetrahedralMesh& mesh, const std::vector<Id>& regions, double rounding)
{
  std::map<std::pair<Id, std::pair<Id, Id>>, std::vector<Id>> uses; // by region and edge
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      const Id other = mesh.Neighbors[c][k];
      const Triangle f = FaceOf(mesh.Cells[c], k);
      for (int i = 0; i < 3 && (other == None || regions[other] != regions[c]); ++i)
      {
        uses[{ regions[c], std::minmax(f[i], f[(i + 1) % 3]) }].push_back(4 * c + k);
      }
    }
  }
  DisjointSets sets(4 * mesh.Cells.size());
  std::map<Id, Id> patches;
  for (const auto& [edge, faces] : uses)
  {
    const Id last = faces.back();
    const Triangle f = FaceOf(mesh.Cells[faces[0] / 4], faces[0] % 4);
    const Triangle g = FaceOf(mesh.Cells[last / 4], last % 4);
    const auto [a, b, d] = CornersOf(mesh.Points, f);
    const Point normal = NormalOf(a, b, d);
    const Point otherNormal = NormalOf(mesh.Points[g[0]], mesh.Points[g[1]], mesh.Points[g[2]]);
    bool isFlat = faces.size() == 2 && Dot(normal, otherNormal) > 0;
    for (const Id corner : g)
    {
      isFlat = isFlat &&
        std::abs(Dot(Difference(mesh.Points[corner], a), normal)) <= rounding * Length(normal);
    }
    if (isFlat)
    {
      sets.Join(faces[0], last);
    }
    for (const Id face : faces)
    {
      patches[face] = 0;
    }
  }
  for (auto& [face, patch] : patches)
  {
    patch = sets.Find(face);
  }
  return patches;
}
} // namespace

void ExpectSplitLaws(
  const TetrahedralMesh& mesh, const std::vector<Id>& regions, const RefinedMesh& refined)
{
  const std::vector<Id> before = regions.empty() ? std::vector<Id>(mesh.Cells.size(), 0) : regions;
  const std::vector<Id> after = RegionsAfter(before, refined);
  const std::vector<SurfaceFace> pieces =
    SurfaceFaces(refined.Cells, after, &refined.OriginalFaces);
  const Box box = BoundingBox(mesh.Points);
  const double rounding = 1e-14 * box.Extent(box.LongestAxis());
  std::map<Id, double> areas;
  std::map<Id, Id> patches = PatchesOf(mesh, before, rounding);
  for (const SurfaceFace& piece : pieces)
  {
    ASSERT_NE(piece.Original, None);
    EXPECT_EQ(before[piece.Original / 4], piece.Region);
    const auto [a, b, c] =
      CornersOf(mesh.Points, FaceOf(mesh.Cells[piece.Original / 4], piece.Original % 4));
    const Point normal = NormalOf(a, b, c);
    const std::array<Point, 3> t = CornersOf(refined.Points, piece.Corners);
    EXPECT_GT(Dot(NormalOf(t[0], t[1], t[2]), normal), 0);
    for (const Point& corner : t)
    {
      EXPECT_LE(std::abs(Dot(Difference(corner, a), normal)), rounding * Length(normal));
    }
    areas[patches.at(piece.Original)] += Length(NormalOf(t[0], t[1], t[2]));
  }
  std::set<Point> there(refined.Points.begin(), refined.Points.end());
  const std::vector<SurfaceFace> facesBefore = SurfaceFaces(mesh.Cells, before, nullptr);
  for (const SurfaceFace& face : facesBefore)
  {
    for (const Id corner : face.Corners)
    {
      EXPECT_EQ(there.count(mesh.Points[corner]), 1U);
    }
  }
  std::map<Id, double> areasBefore;
  for (const auto& [face, patch] : patches)
  {
    const auto [a, b, c] = CornersOf(mesh.Points, FaceOf(mesh.Cells[face / 4], face % 4));
    areasBefore[patch] += Length(NormalOf(a, b, c));
  }
  EXPECT_EQ(areas.size(), areasBefore.size());
  for (const auto& [patch, area] : areasBefore)
  {
    EXPECT_NEAR(areas[patch] / area, 1, 1e-9) << "patch of face " << patch;
  }
  const std::map<Id, double> volumes = VolumesOf(refined.Points, refined.Cells, after);
  for (const auto& [region, volume] : VolumesOf(mesh.Points, mesh.Cells, before))
  {
    EXPECT_NEAR(volumes.at(region) / volume, 1, 1e-9);
  }
  ExpectNoCrossings(mesh, refined);
}

void ExpectRemeshingLaws(const TetrahedralMesh& mesh, const std::vector<Id>& regions,
  const RefinedMesh& refined, double tolerance)
{
  const std::vector<Id> before = regions.empty() ? std::vector<Id>(mesh.Cells.size(), 0) : regions;
  const std::vector<Id> after = RegionsAfter(before, refined);
  const std::vector<SurfaceFace> old = SurfaceFaces(mesh.Cells, before, nullptr);
  const std::vector<SurfaceFace> fresh = SurfaceFaces(refined.Cells, after, &refined.OriginalFaces);
  EXPECT_EQ(EulerCharacteristics(old), EulerCharacteristics(fresh));
  ExpectNoCrossings(mesh, refined);
  const auto expectNear =
    [&](const std::vector<SurfaceFace>& faces, const std::vector<Point>& points,
      const std::vector<SurfaceFace>& others, const std::vector<Point>& otherPoints)
  {
    for (const SurfaceFace& face : faces)
    {
      const std::array<Point, 3> t = CornersOf(points, face.Corners);
      for (const auto& [u, v] : { std::pair(0.0, 0.0), { 0.0, 0.5 }, { 0.5, 0.5 }, { 0.3, 0.3 } })
      {
        EXPECT_LE(DistanceFrom(WithinFace(t, u, v), others, otherPoints, face.Region),
          tolerance * (1 + 1e-9));
      }
    }
  };
  expectNear(fresh, refined.Points, old, mesh.Points);
  expectNear(old, mesh.Points, fresh, refined.Points);
  for (const SurfaceFace& face : fresh)
  {
    EXPECT_EQ(before[face.Original / 4], face.Region);
  }
}

double ShareOfGoodEdges(
  const RefinedMesh& refined, const std::function<double(const Point&)>& wanted)
{
  const TetrahedralMesh mesh = ConnectCells(refined.Points, refined.Cells);
  std::set<std::pair<Id, Id>> inner;
  std::set<std::pair<Id, Id>> outer;
  for (std::size_t c = 0; c < mesh.Cells.size(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      const Triangle f = FaceOf(mesh.Cells[c], k);
      for (int i = 0; i < 3; ++i)
      {
        auto& edges = mesh.Neighbors[c][k] == None ? outer : inner;
        edges.insert(std::minmax(f[i], f[(i + 1) % 3]));
      }
    }
  }
  int good = 0;
  int all = 0;
  for (const auto& [p, q] : inner)
  {
    if (outer.count({ p, q }) == 0)
    {
      const Point& a = mesh.Points[p];
      const Point& b = mesh.Points[q];
      const double length = wanted({ { (a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2 } });
      const double ratio = Distance(a, b) / length;
      good += ratio > 1 / 1.4 && ratio < 1.4 ? 1 : 0;
      ++all;
    }
  }
  return static_cast<double>(good) / all;
}

std::vector<double> LeastSines(
  const std::vector<Point>& points, const std::vector<Tetrahedron>& cells)
{
  std::vector<double> sines;
  for (const Tetrahedron& cell : cells)
  {
    std::array<Point, 4> normals;
    for (int k = 0; k < 4; ++k)
    {
      const Triangle f = FaceOf(cell, k);
      normals[k] = NormalOf(points[f[0]], points[f[1]], points[f[2]]);
    }
    double least = 1;
    for (int i = 0; i < 4; ++i)
    {
      for (int j = i + 1; j < 4; ++j)
      {
        least = std::min(
          least, Length(Cross(normals[i], normals[j])) / (Length(normals[i]) * Length(normals[j])));
      }
    }
    sines.push_back(least);
  }
  std::sort(sines.begin(), sines.end());
  return sines;
}
} // namespace testmeshes
