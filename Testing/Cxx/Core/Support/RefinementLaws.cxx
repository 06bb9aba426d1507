// SPDX-License-Identifier: GPL-3.0-or-later
#include "Support/RefinementLaws.h"

#include "Common/PointPredicates.h"
#include "Common/Vectors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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
