// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/RefineTetrahedra.h"

#include "Common/PointPredicates.h"
#include "Common/ScaledPoints.h"
#include "Common/Stages.h"
#include "Common/Vectors.h"
#include "GraphCut/ConnectCells.h"
#include "Support/AllowedThreads.h"
#include "Support/RefinementLaws.h"
#include "Support/TestTetrahedra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace insideout;
using testmeshes::ExpectRefinementLaws;
using testmeshes::ShareOfGoodEdges;
using testtetrahedra::Part;

namespace
{
RefinedMesh Refined(const TetrahedralMesh& mesh, const std::vector<Id>& regions = {},
  const SizingParameters& parameters = {})
{
  Monitor monitor;
  RefinementParameters all;
  all.Sizes = parameters;
  return RefineTetrahedra(mesh, regions, all, monitor);
}

/** A cube of edge 1, divided into this number of cubes along each axis, of six tetrahedra each. */
TetrahedralMesh Cube(int size)
{
  TetrahedralMesh grid = testtetrahedra::EvenGrid(size);
  for (Point& p : grid.Points)
  {
    for (double& x : p)
    {
      x = x / 100 / size;
    }
  }
  return ConnectCells(grid.Points, grid.Cells);
}

class CountingMonitor : public Monitor
{
public:
  explicit CountingMonitor(int allowed)
    : Allowed(allowed)
  {
  }

  bool Continue(const char* stage, double fraction) override
  {
    EXPECT_STREQ(stage, Stages::Refining);
    EXPECT_GE(fraction, this->Last);
    EXPECT_LE(fraction, 1);
    this->Last = fraction;
    return ++this->Reports <= this->Allowed;
  }

  int Reports = 0;

private:
  const int Allowed;
  double Last = 0;
};
} // namespace

class RefineRandomMeshes : public testing::TestWithParam<unsigned>
{
};

TEST_P(RefineRandomMeshes, KeepsAnySolidWithItsSurface)
{
  const TetrahedralMesh grid = testtetrahedra::Grid(GetParam(), 4);
  const TetrahedralMesh part = Part(grid, testtetrahedra::RandomInside(grid, GetParam()));
  ExpectRefinementLaws(part, {}, Refined(part));
}

TEST_P(RefineRandomMeshes, KeepsTheFacesBetweenRegions)
{
  const TetrahedralMesh grid = testtetrahedra::Grid(GetParam(), 3);
  const std::vector<int> labels = testtetrahedra::RandomLabels(grid, GetParam());
  const std::vector<Id> regions(labels.begin(), labels.end());
  ExpectRefinementLaws(grid, regions, Refined(grid, regions));
}

TEST_P(RefineRandomMeshes, TakesCellsThatAreAllButFlat)
{
  TetrahedralMesh grid = testtetrahedra::Grid(GetParam(), 5);
  ASSERT_GT(testtetrahedra::Flatten(grid, GetParam()), 0);
  const std::vector<double> before = testmeshes::LeastSines(grid.Points, grid.Cells);
  const RefinedMesh refined = Refined(grid);
  ExpectRefinementLaws(grid, {}, refined);
  EXPECT_LT(before.front(), 1e-6);
  EXPECT_GT(testmeshes::LeastSines(refined.Points, refined.Cells).front(), 0.05);
}

TEST_P(RefineRandomMeshes, TakesWhatIsSqueezed)
{
  for (const double factor : { 1e-3, 1e-9, 1e-150, 1e100 })
  {
    TetrahedralMesh grid = testtetrahedra::Grid(GetParam(), 3);
    testtetrahedra::Squeeze(grid, 1, factor);
    ExpectRefinementLaws(grid, {}, Refined(grid));
  }
}

TEST_P(RefineRandomMeshes, IsTheSameAtAnySize)
{
  const TetrahedralMesh grid = testtetrahedra::Grid(GetParam(), 4);
  const std::vector<int> labels = testtetrahedra::RandomLabels(grid, GetParam());
  const std::vector<Id> regions(labels.begin(), labels.end());
  SizingParameters parameters;
  parameters.EdgeLength = 60;
  parameters.LengthAt = [](const Point& p) { return 40 + p[0] / 8; };
  const RefinedMesh ordinary = Refined(grid, regions, parameters);
  for (const int exponent : { -600, -150, 130, 900 })
  {
    TetrahedralMesh scaled = grid;
    scaled.Points = ScaledPoints(grid.Points, exponent);
    SizingParameters other;
    other.EdgeLength = std::ldexp(60, exponent);
    other.LengthAt = [&](const Point& p)
    { return std::ldexp(40 + std::ldexp(p[0], -exponent) / 8, exponent); };
    const RefinedMesh refined = Refined(scaled, regions, other);
    ExpectRefinementLaws(scaled, regions, refined);
    EXPECT_EQ(refined.Cells.size(), ordinary.Cells.size()) << exponent;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RefineRandomMeshes, testing::Range(0U, 6U));

TEST(RefineTetrahedra, LeavesNoBadCellWhereTheSurfaceForcesNone)
{
  const TetrahedralMesh grid = testtetrahedra::Grid(1, 8);
  const RefinedMesh refined = Refined(grid);
  EXPECT_GT(
    testmeshes::LeastSines(refined.Points, refined.Cells).front(), std::sin(0.38)); // 22 degrees
}

TEST(RefineTetrahedra, LeavesOneCellAsItIs)
{
  const TetrahedralMesh one =
    ConnectCells({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, { { { 0, 1, 2, 3 } } });
  const RefinedMesh refined = Refined(one);
  EXPECT_EQ(refined.Points, one.Points);
  EXPECT_EQ(refined.Cells, one.Cells);
  EXPECT_EQ(refined.OriginalPoints, (std::vector<Id>{ 0, 1, 2, 3 }));
}

TEST(RefineTetrahedra, GivesTheSameTwice)
{
  const TetrahedralMesh grid = testtetrahedra::Grid(3, 6);
  const RefinedMesh first = Refined(grid);
  const RefinedMesh second = Refined(grid);
  EXPECT_EQ(first.Points, second.Points);
  EXPECT_EQ(first.Cells, second.Cells);
  EXPECT_EQ(first.OriginalCells, second.OriginalCells);
}

TEST(RefineTetrahedra, MakesNineOfTenEdgesAsLongAsAskedFor)
{
  SizingParameters parameters;
  parameters.EdgeLength = 1.0 / 12;
  const RefinedMesh refined = Refined(Cube(12), {}, parameters);
  EXPECT_GT(ShareOfGoodEdges(refined, [&](const Point&) { return parameters.EdgeLength; }), 0.9);
}

TEST(RefineTetrahedra, TakesPointsOutWhereEdgesMayBeLonger)
{
  SizingParameters parameters;
  parameters.EdgeLength = 0.25;
  const TetrahedralMesh fine = Cube(16);
  const RefinedMesh refined = Refined(fine, {}, parameters);
  ExpectRefinementLaws(fine, {}, refined);
  EXPECT_LT(refined.Cells.size(), fine.Cells.size() * 3 / 4);
}

TEST(RefineTetrahedra, FollowsLengthsAtPointsAndAnywhere)
{
  // A surface as fine as the finest that is wanted, so that only the wish counts.
  const auto wanted = [](const Point& p) { return 0.06 + 0.12 * p[0]; };
  const TetrahedralMesh cube = Cube(14);
  SizingParameters atPoints;
  atPoints.Grading = 100;
  for (const Point& p : cube.Points)
  {
    atPoints.Lengths.push_back(wanted(p));
  }
  SizingParameters anywhere;
  anywhere.Grading = 100;
  anywhere.LengthAt = wanted;
  for (const SizingParameters& parameters : { atPoints, anywhere })
  {
    const RefinedMesh refined = Refined(cube, {}, parameters);
    ExpectRefinementLaws(cube, {}, refined);
    EXPECT_GT(ShareOfGoodEdges(refined, wanted), 0.75);
  }
}

TEST(RefineTetrahedra, MakesNothingWhereThereWouldBeMoreCellsThanAllowed)
{
  Monitor monitor;
  RefinementParameters parameters;
  parameters.MaximumCells = 100;
  const TetrahedralMesh cube = Cube(3); // nothing is asked for
  EXPECT_GT(RefineTetrahedra(cube, {}, parameters, monitor).Cells.size(), 100U);
  parameters.Sizes.EdgeLength = 0.2;
  EXPECT_THROW(RefineTetrahedra(cube, {}, parameters, monitor), Error);
  parameters.MaximumCells = 0;
  EXPECT_GT(RefineTetrahedra(cube, {}, parameters, monitor).Cells.size(), 100U);
}

TEST(RefineTetrahedra, CountsCellsThatStayTooLarge)
{
  SizingParameters parameters;
  parameters.MaximumVolume = 1e-4;
  const auto large = [&](const RefinedMesh& refined)
  {
    EXPECT_EQ(refined.Statistics.back().first, "CellsAboveMaximumVolume");
    return refined.Statistics.back().second;
  };
  EXPECT_EQ(large(Refined(Cube(16), {}, parameters)), 0);
  EXPECT_GT(large(Refined(Cube(1), {}, parameters)), 0) << "faces of area 1/2 are kept";
}

TEST(RefineTetrahedra, NamesWhatItCannotTake)
{
  const auto errorOf = [](const TetrahedralMesh& mesh, const SizingParameters& parameters)
  {
    try
    {
      Refined(mesh, {}, parameters);
    }
    catch (const Error& error)
    {
      return std::string(error.what());
    }
    return std::string("none");
  };
  const TetrahedralMesh cube = Cube(2);
  TetrahedralMesh flat = cube;
  flat.Cells[5][3] = flat.Cells[5][2];
  EXPECT_EQ(errorOf(flat, {}), "cell 5 has no volume");
  const std::vector<Point> corners = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 0.2, 0.2, 0.6 } };
  const TetrahedralMesh sameSide =
    ConnectCells(corners, { { { 0, 1, 2, 3 } }, { { 0, 1, 2, 4 } } });
  EXPECT_EQ(errorOf(sameSide, {}), "cells 0 and 1 overlap: they are on the same side of a face");
  const TetrahedralMesh twice = ConnectCells(corners, { { { 0, 1, 2, 3 } }, { { 0, 1, 2, 3 } } });
  EXPECT_EQ(errorOf(twice, {}), "cells 0 and 1 overlap: they are on the same side of a face");
  SizingParameters lengths;
  lengths.Lengths.assign(cube.Points.size(), 1);
  lengths.Lengths[7] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(errorOf(cube, lengths), "the edge length at point 7 is not positive");
  SizingParameters tiny;
  tiny.EdgeLength = 1e-6;
  EXPECT_EQ(errorOf(cube, tiny),
    "edges as short as asked for would make about 8.5e+18 cells, more than can be counted");
  TetrahedralMesh large = cube;
  large.Points = ScaledPoints(cube.Points, 900);
  SizingParameters small;
  small.MaximumVolume = 1e-300;
  EXPECT_NE(errorOf(large, small).find("more than can be counted"), std::string::npos);
}

TEST(RefineTetrahedra, TakesATinyDetailOfALargeSolid)
{
  // Points on one face of a tetrahedron, each in a triangle of those before: the last one has
  // neighbors on the face that are all at hand. As fine everywhere, cells could not be counted.
  std::vector<Point> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  std::vector<Tetrahedron> cells = { { { 0, 1, 2, 3 } } };
  const double x = 0.25;
  const double d = 0x1p-24;
  for (const Point& place : { Point{ { x, x, 0 } }, { { x + 4 * d, x, 0 } },
         { { x + 3 * d, x + d, 0 } }, { { x + 2.5 * d, x + 0.5 * d, 0 } } })
  {
    const auto added = static_cast<Id>(points.size());
    points.push_back(place);
    std::vector<Tetrahedron> after;
    for (const Tetrahedron& c : cells)
    {
      const std::array<Tetrahedron, 3> parts = { { { { c[0], c[1], added, 3 } },
        { { c[1], c[2], added, 3 } }, { { c[2], c[0], added, 3 } } } };
      const bool holds = std::all_of(parts.begin(), parts.end(),
        [&](const Tetrahedron& part) { return Orient3D(points, part) > 0; });
      after.insert(after.end(), holds ? parts.begin() : &c, holds ? parts.end() : &c + 1);
    }
    ASSERT_EQ(after.size(), cells.size() + 2);
    cells = after;
  }
  const TetrahedralMesh mesh = ConnectCells(points, cells);
  const RefinedMesh refined = Refined(mesh);
  ExpectRefinementLaws(mesh, {}, refined);
  EXPECT_LT(refined.Cells.size(), 5000U);
}

/** Cells that were to be regular beside such an edge would be as small as it is, without number. */
TEST(RefineTetrahedra, EndsBesideTwoPointsThatAreAllButOne)
{
  TetrahedralMesh cube = Cube(2);
  // An edge on the cube's top, from the middle of the face to that of a side, in three.
  const Point from = { 0.5, 0.5, 1 };
  const Point to = { 1, 0.5, 1 };
  const auto at = [&](const Point& place)
  {
    return static_cast<Id>(
      std::find(cube.Points.begin(), cube.Points.end(), place) - cube.Points.begin());
  };
  const std::array<Id, 4> along = { at(from), static_cast<Id>(cube.Points.size()),
    static_cast<Id>(cube.Points.size()) + 1, at(to) };
  cube.Points.push_back({ 0.75, 0.5, 1 });
  cube.Points.push_back({ 0.75 + 0x1p-50, 0.5, 1 });
  std::vector<Tetrahedron> cells;
  for (const Tetrahedron& cell : cube.Cells)
  {
    const auto first = std::find(cell.begin(), cell.end(), along[0]);
    const auto last = std::find(cell.begin(), cell.end(), along[3]);
    if (first == cell.end() || last == cell.end())
    {
      cells.push_back(cell);
      continue;
    }
    for (std::size_t piece = 0; piece < 3; ++piece)
    {
      cells.push_back(cell);
      cells.back()[first - cell.begin()] = along[piece];
      cells.back()[last - cell.begin()] = along[piece + 1];
    }
  }
  ASSERT_GT(cells.size(), cube.Cells.size());
  const TetrahedralMesh mesh = ConnectCells(cube.Points, cells);
  const RefinedMesh refined = Refined(mesh);
  ExpectRefinementLaws(mesh, {}, refined);
  EXPECT_LT(refined.Cells.size(), 1000U);
}

TEST(RefineTetrahedra, StopsAtEveryReport)
{
  const testthreads::Allowed one(1); // with more, chance has it how often the caller reports
  for (const SurfaceTreatment treatment :
    { SurfaceTreatment::Kept, SurfaceTreatment::Split, SurfaceTreatment::Remeshed })
  {
    const TetrahedralMesh grid =
      testtetrahedra::Grid(2, treatment == SurfaceTreatment::Kept ? 5 : 2);
    RefinementParameters parameters;
    parameters.Surface = treatment;
    CountingMonitor all(std::numeric_limits<int>::max());
    RefineTetrahedra(grid, {}, parameters, all);
    ASSERT_GT(all.Reports, 5);
    for (int allowed = 0; allowed < all.Reports; ++allowed)
    {
      CountingMonitor some(allowed);
      EXPECT_THROW(RefineTetrahedra(grid, {}, parameters, some), Error) << allowed;
    }
  }
}
