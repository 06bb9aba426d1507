// SPDX-License-Identifier: GPL-3.0-or-later
#include "Tetrahedralize/CheckConvexHull.h"

#include "Support/TestMeshes.h"
#include "Tetrahedralize/AssembleMesh.h"
#include "Tetrahedralize/DelaunayOfPoints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace insideout;

namespace
{
TetrahedralMesh WithNeighbors(std::vector<Point> points, std::vector<Tetrahedron> cells)
{
  TetrahedralMesh mesh;
  mesh.Points = std::move(points);
  mesh.Cells = std::move(cells);
  mesh.Neighbors.assign(mesh.Cells.size(), { { None, None, None, None } });
  std::map<Triangle, std::pair<Id, int>> open;
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      Triangle corners;
      for (int i = 0; i < 3; ++i)
      {
        corners[i] = mesh.Cells[c][TetrahedronFaces[k][i]];
      }
      std::sort(corners.begin(), corners.end());
      const auto inserted = open.insert({ corners, { c, k } });
      if (!inserted.second)
      {
        const auto [other, face] = inserted.first->second;
        mesh.Neighbors[c][k] = other;
        mesh.Neighbors[other][face] = c;
      }
    }
  }
  return mesh;
}

void ExpectRefused(const TetrahedralMesh& mesh, const std::string& part)
{
  try
  {
    CheckConvexHull(mesh, mesh.Points.size());
    FAIL() << "accepted";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::Inconsistent);
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TetrahedralMesh DelaunayMesh(const std::vector<Point>& points)
{
  Monitor monitor;
  FacetComplex surface;
  surface.Points = points;
  surface.Origins.resize(points.size());
  return AssembleMesh(surface, DelaunayOfPoints(points, HUGE_VAL, monitor), monitor);
}

std::vector<Point> GridPoints(int n)
{
  std::vector<Point> points;
  for (int i = 0; i < n * n * n; ++i)
  {
    points.push_back({ { double(i % n), double(i / n % n), double(i / n / n) } });
  }
  return points;
}

/** Cells between an axis and a ring of points around it that goes round twice, convex everywhere:
 * its radius is larger the first time. */
TetrahedralMesh TwiceAround(int axis)
{
  constexpr int Count = 20;
  std::vector<Point> points(2, Point{ { 0, 0, 0 } });
  points[0][axis] = 1;
  points[1][axis] = -1;
  std::vector<Tetrahedron> cells;
  for (Id i = 0; i < Count; ++i)
  {
    const double angle = 4 * M_PI * i / Count;
    const double radius = 2 + 0.5 * std::cos(angle / 2);
    Point p{ { 0, 0, 0 } };
    p[(axis + 1) % 3] = radius * std::cos(angle);
    p[(axis + 2) % 3] = radius * std::sin(angle);
    points.push_back(p);
    cells.push_back({ 1, 0, 2 + i, 2 + (i + 1) % Count });
  }
  return WithNeighbors(points, cells);
}
} // namespace

TEST(CheckConvexHull, AcceptsConvexMeshes)
{
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    EXPECT_NO_THROW(DelaunayMesh(testmeshes::RandomSoup(seed, 10 * int(seed)).Points));
    EXPECT_NO_THROW(DelaunayMesh(testmeshes::Merged(testmeshes::GridSoup(seed, 30, 4)).Points));
  }
}

TEST(CheckConvexHull, AcceptsFlatSidesWithPointsOnThem)
{
  for (const int n : { 2, 3, 6 })
  {
    EXPECT_NO_THROW(DelaunayMesh(GridPoints(n)));
  }
}

TEST(CheckConvexHull, RefusesAMissingCell)
{
  for (const std::vector<Point>& points :
    { testmeshes::RandomSoup(1, 8).Points, GridPoints(3), testmeshes::RandomSoup(2, 3).Points })
  {
    const TetrahedralMesh whole = DelaunayMesh(points);
    for (std::size_t c = 0; c < whole.Cells.size(); ++c)
    {
      std::vector<Tetrahedron> cells = whole.Cells;
      cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(c));
      const TetrahedralMesh mesh = WithNeighbors(whole.Points, cells);
      // A corner may be cut off flatly; then what is left is convex, and a point in no cell.
      std::vector<char> used(whole.Points.size(), 0);
      for (const Tetrahedron& cell : cells)
      {
        for (const Id p : cell)
        {
          used[p] = 1;
        }
      }
      if (std::find(used.begin(), used.end(), 0) == used.end())
      {
        ExpectRefused(mesh, "the mesh is inconsistent: its hull ");
      }
    }
  }
}

TEST(CheckConvexHull, RefusesTwoMeshesInOnePlace)
{
  const TetrahedralMesh once = DelaunayMesh(GridPoints(2));
  std::vector<Point> points = once.Points;
  std::vector<Tetrahedron> cells = once.Cells;
  points.insert(points.end(), once.Points.begin(), once.Points.end());
  for (Tetrahedron cell : once.Cells)
  {
    for (Id& p : cell)
    {
      p += 8;
    }
    cells.push_back(cell);
  }
  ExpectRefused(WithNeighbors(points, cells), "has 2 peaks");
}

TEST(CheckConvexHull, RefusesAMeshThatGoesRoundTwice)
{
  ExpectRefused(TwiceAround(0), "winds around point 0");
  ExpectRefused(TwiceAround(1), "has 2 peaks");
  ExpectRefused(TwiceAround(2), "has 2 peaks");
}

TEST(CheckConvexHull, LetsRoundedSteinerPointsDentTheHull)
{
  // A point on a slanted face, one bit inside it.
  std::vector<Point> points = { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } },
    { { 0.3, 0.3, 0.39999999999999997 } } };
  const std::vector<Tetrahedron> cells = { { { 0, 1, 2, 4 } }, { { 0, 2, 3, 4 } },
    { { 0, 3, 1, 4 } } };
  TetrahedralMesh mesh = WithNeighbors(points, cells);
  EXPECT_THROW(CheckConvexHull(mesh, 5), Error);
  EXPECT_NO_THROW(CheckConvexHull(mesh, 4));
  mesh.Points[4] = { { 0.3, 0.3, 0.3999999999 } };
  EXPECT_THROW(CheckConvexHull(mesh, 4), Error);
}
