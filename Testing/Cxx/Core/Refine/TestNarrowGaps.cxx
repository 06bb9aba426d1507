// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/Vectors.h"
#include "GraphCut/ConnectCells.h"
#include "Refine/RefineTetrahedra.h"
#include "Support/RefinementLaws.h"
#include "Support/TestTetrahedra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

using namespace insideout;
using testmeshes::ExpectRemeshingLaws;
using testmeshes::ExpectSplitLaws;
using testtetrahedra::Cubes;
using testtetrahedra::EvenGrid;
using testtetrahedra::Part;

namespace
{
double StatisticOf(const RefinedMesh& refined, const std::string& name)
{
  const auto found = std::find_if(refined.Statistics.begin(), refined.Statistics.end(),
    [&](const auto& entry) { return entry.first == name; });
  EXPECT_NE(found, refined.Statistics.end()) << name;
  return found == refined.Statistics.end() ? -1 : found->second;
}

std::ptrdiff_t CountBoundary(const TetrahedralMesh& mesh)
{
  std::ptrdiff_t count = 0;
  for (const std::array<Id, 4>& neighbors : mesh.Neighbors)
  {
    count += std::count(neighbors.begin(), neighbors.end(), None);
  }
  return count;
}

/** A wide strip that is rolled up, each turn so far from the next, more or less. Radii are 2 to 5.
 */
TetrahedralMesh Roll(unsigned seed, double gap)
{
  constexpr int size = 24;
  constexpr int stepsPerTurn = 12;
  const TetrahedralMesh grid = EvenGrid(size);
  TetrahedralMesh strip = Part(grid, Cubes(grid, [](int, int y, int z) { return y < 1 && z < 8; }));
  std::mt19937 random(seed);
  for (Point& p : strip.Points)
  {
    const double noise = gap / 5 * static_cast<double>(random() % 1000) / 1000;
    const double turns = p[0] / 100 / stepsPerTurn;
    const double radius = 2 + turns + (1 - gap) * p[1] / 100 + noise;
    const double angle = turns * 2 * std::acos(-1.0);
    p = { { radius * std::cos(angle), radius * std::sin(angle), -p[2] / 200 } };
  }
  return ConnectCells(strip.Points, strip.Cells);
}

/** A wavy block of edge 600 that is cut in two, with a gap so wide, or of the least
 * width. */
TetrahedralMesh CutBlock(unsigned seed, double gap)
{
  const TetrahedralMesh grid = EvenGrid(6);
  TetrahedralMesh block = Part(grid, Cubes(grid, [](int, int y, int) { return y != 3; }));
  std::mt19937 random(seed);
  const double phase = static_cast<double>(random() % 1000) / 100;
  for (Point& p : block.Points)
  {
    const double wave = 15 * std::sin(p[0] / 100 + phase) + 10 * std::cos(p[2] / 80 + phase);
    const bool isAbove = p[1] > 300;
    p[1] = (isAbove ? p[1] - 100 : p[1]) + wave;
    p[1] = isAbove ? std::max(p[1] + gap, std::nextafter(p[1], 1e3)) : p[1];
  }
  return ConnectCells(block.Points, block.Cells);
}

RefinedMesh Refined(const TetrahedralMesh& mesh, const RefinementParameters& parameters)
{
  Monitor monitor;
  return RefineTetrahedra(mesh, {}, parameters, monitor);
}

/** Expect a surface with far fewer triangles, all of it remeshed. */
void ExpectCoarser(const TetrahedralMesh& mesh, double tolerance, double length)
{
  RefinementParameters parameters;
  parameters.Surface = SurfaceTreatment::Remeshed;
  parameters.SurfaceTolerance = tolerance;
  parameters.Sizes.EdgeLength = length;
  parameters.FeatureAngle = 50;
  const RefinedMesh refined = Refined(mesh, parameters);
  ExpectRemeshingLaws(mesh, {}, refined, tolerance);
  EXPECT_EQ(StatisticOf(refined, "KeptFacets"), 0);
  EXPECT_LT(CountBoundary(ConnectCells(refined.Points, refined.Cells)), 0.7 * CountBoundary(mesh));
}
} // namespace

class NarrowGaps : public testing::TestWithParam<unsigned>
{
};

TEST_P(NarrowGaps, StayWhereTurnsOfARollAreRemeshed)
{
  ExpectCoarser(Roll(GetParam(), 0.02), 0.2, 1.5);
  ExpectCoarser(Roll(GetParam(), 1e-9), 0.2, 1.5);
}

TEST_P(NarrowGaps, StayWhereTheSidesOfACutAreRemeshed)
{
  ExpectCoarser(CutBlock(GetParam(), 1), 10, 200);
  ExpectCoarser(CutBlock(GetParam(), 1e-12), 10, 200);
}

TEST_P(NarrowGaps, StayWhereTheSidesOfACutAreSplitAsNearAsRoundingPermits)
{
  const TetrahedralMesh block = CutBlock(GetParam(), 0);
  RefinementParameters parameters;
  parameters.Surface = SurfaceTreatment::Split;
  parameters.Sizes.EdgeLength = 60;
  const RefinedMesh refined = Refined(block, parameters);
  ExpectSplitLaws(block, {}, refined);
  EXPECT_EQ(StatisticOf(refined, "KeptFacets"), 0);
  EXPECT_GT(CountBoundary(ConnectCells(refined.Points, refined.Cells)), 2 * CountBoundary(block));
}

INSTANTIATE_TEST_SUITE_P(Seeds, NarrowGaps, testing::Range(0U, 4U));

TEST(NarrowGaps, AreOnlyKeptWhereTheyHaveNoWidth)
{
  // Two blocks that touch in a side, with points of their own: its facets stay, and no others.
  const TetrahedralMesh block = EvenGrid(4);
  std::vector<Point> points = block.Points;
  std::vector<Tetrahedron> cells = block.Cells;
  const Id shift = static_cast<Id>(points.size());
  for (const Point& p : block.Points)
  {
    points.push_back({ { p[0] + 400, p[1], p[2] } });
  }
  for (Tetrahedron cell : block.Cells)
  {
    for (Id& corner : cell)
    {
      corner += shift;
    }
    cells.push_back(cell);
  }
  const TetrahedralMesh both = ConnectCells(points, cells);
  RefinementParameters parameters;
  parameters.Surface = SurfaceTreatment::Remeshed;
  parameters.SurfaceTolerance = 20;
  parameters.Sizes.EdgeLength = 180;
  const RefinedMesh refined = Refined(both, parameters);
  ExpectRemeshingLaws(both, {}, refined, 20);
  // 32 on each side, and those of other sides that touch them in an edge or a corner.
  EXPECT_EQ(StatisticOf(refined, "KeptFacets"), 2 * (32 + 4 * 8));
}
