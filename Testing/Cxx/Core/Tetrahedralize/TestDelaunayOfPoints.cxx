// SPDX-License-Identifier: GPL-3.0-or-later
#include "Tetrahedralize/DelaunayOfPoints.h"

#include "Support/MeshLaws.h"
#include "Support/TestMeshes.h"
#include "Tetrahedralize/AssembleMesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <gtest/gtest.h>

using namespace insideout;

namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

TetrahedralMesh CheckedMesh(const std::vector<Point>& points)
{
  TriangleSoup soup;
  soup.Points = points;
  const FacetComplex surface = testmeshes::ToComplex(soup);
  Monitor monitor;
  const TetrahedralMesh mesh =
    AssembleMesh(surface, DelaunayOfPoints(points, HUGE_VAL, monitor), monitor);
  testmeshes::ExpectMeshLaws(surface, mesh);
  return mesh;
}

void ExpectEmptySpheres(const TetrahedralMesh& mesh)
{
  const auto at = [&](Id p)
  { return Kernel::Point_3(mesh.Points[p][0], mesh.Points[p][1], mesh.Points[p][2]); };
  for (const Tetrahedron& cell : mesh.Cells)
  {
    for (Id p = 0; p < static_cast<Id>(mesh.Points.size()); ++p)
    {
      ASSERT_NE(
        CGAL::side_of_oriented_sphere(at(cell[0]), at(cell[1]), at(cell[2]), at(cell[3]), at(p)),
        CGAL::ON_POSITIVE_SIDE);
    }
  }
}
} // namespace

TEST(DelaunayOfPoints, HasEmptySpheres)
{
  for (unsigned seed = 1; seed <= 5; ++seed)
  {
    ExpectEmptySpheres(CheckedMesh(testmeshes::RandomSoup(seed, 30).Points));
  }
}

TEST(DelaunayOfPoints, HasNoFlatCellAmongCosphericalAndCoplanarPoints)
{
  for (unsigned seed = 1; seed <= 10; ++seed)
  {
    ExpectEmptySpheres(CheckedMesh(testmeshes::GridSoup(seed, 60, 4).Points));
  }
  // A grid in every order: the first points may be in one plane, or on one line.
  std::vector<Point> grid;
  for (int i = 0; i < 216; ++i)
  {
    grid.push_back({ { double(i % 6), double(i / 6 % 6), double(i / 36) } });
  }
  std::mt19937 random(3);
  for (int run = 0; run < 5; ++run)
  {
    CheckedMesh(grid);
    std::shuffle(grid.begin(), grid.end(), random);
  }
}

TEST(DelaunayOfPoints, UsesTheFirstOfEqualPoints)
{
  std::vector<Point> points = testmeshes::RandomSoup(6, 20).Points;
  const std::size_t count = points.size();
  points.insert(points.end(), points.begin(), points.end());
  Monitor monitor;
  for (const Tetrahedron& cell : DelaunayOfPoints(points, HUGE_VAL, monitor).Cells)
  {
    for (const Id p : cell)
    {
      EXPECT_LT(static_cast<std::size_t>(p), count);
    }
  }
}

TEST(DelaunayOfPoints, GivesTheSameTwice)
{
  const std::vector<Point> points = testmeshes::GridSoup(4, 200, 7).Points;
  Monitor monitor;
  EXPECT_EQ(DelaunayOfPoints(points, HUGE_VAL, monitor).Cells,
    DelaunayOfPoints(points, HUGE_VAL, monitor).Cells);
}

TEST(DelaunayOfPoints, EndsWhereEachPairOfPointsHasACell)
{
  // Points on two lines that pass each other: a million cells of two thousand points.
  std::vector<Point> points;
  for (int i = 0; i < 2000; ++i)
  {
    points.push_back({ { double(i), 0, 0 } });
    points.push_back({ { 0, double(i), 1000 } });
  }
  Monitor monitor;
  try
  {
    DelaunayOfPoints(points, 20, monitor);
    FAIL() << "no error";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::TetrahedralizerFailed) << error.what();
  }
}
