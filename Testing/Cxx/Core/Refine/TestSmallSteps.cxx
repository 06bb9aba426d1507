// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/Vectors.h"
#include "GraphCut/ConnectCells.h"
#include "Refine/RefineTetrahedra.h"
#include "Support/RefinementLaws.h"
#include "Support/TestTetrahedra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

using namespace insideout;
using testmeshes::ExpectRemeshingLaws;
using testmeshes::LeastSines;
using testtetrahedra::Cubes;
using testtetrahedra::EvenGrid;
using testtetrahedra::Part;

namespace
{
constexpr double Tolerance = 1;
constexpr int Size = 4;

/** A block of edge 400, half of whose top is higher by a step. The surface has corners there, and
 * triangles as low as the step. */
TetrahedralMesh BlockWithStep(double step)
{
  const TetrahedralMesh grid = EvenGrid(Size);
  TetrahedralMesh block =
    Part(grid, Cubes(grid, [](int x, int, int z) { return z < Size - 1 || x < Size / 2; }));
  for (Point& p : block.Points)
  {
    p[2] = p[2] == 100 * Size ? 100 * (Size - 1) + step : p[2];
  }
  return ConnectCells(block.Points, block.Cells);
}

RefinementParameters Remeshed(double length)
{
  RefinementParameters parameters;
  parameters.Surface = SurfaceTreatment::Remeshed;
  parameters.SurfaceTolerance = Tolerance;
  parameters.Sizes.EdgeLength = length;
  return parameters;
}

/** The step has a label of its own. */
RefinementParameters RemeshedWithLabelOfStep(const TetrahedralMesh& block)
{
  RefinementParameters parameters = Remeshed(150);
  parameters.Labels.assign(block.Cells.size(), { { 0, 0, 0, 0 } });
  for (std::size_t c = 0; c < block.Cells.size(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      const auto places = CornersOf(block.Points, FaceOf(block.Cells[c], k));
      const bool isOfStep = std::all_of(places.begin(), places.end(),
        [](const Point& p) { return p[0] == 100 * (Size / 2) && p[2] >= 100 * (Size - 1); });
      parameters.Labels[c][k] = isOfStep ? 1 : 0;
    }
  }
  return parameters;
}

RefinedMesh Refined(const TetrahedralMesh& mesh, const RefinementParameters& parameters)
{
  Monitor monitor;
  return RefineTetrahedra(mesh, {}, parameters, monitor);
}

double ShortestEdge(const RefinedMesh& refined)
{
  double shortest = std::numeric_limits<double>::infinity();
  for (const Tetrahedron& cell : refined.Cells)
  {
    for (int i = 0; i < 4; ++i)
    {
      for (int j = 0; j < i; ++j)
      {
        shortest = std::min(shortest, Distance(refined.Points[cell[i]], refined.Points[cell[j]]));
      }
    }
  }
  return shortest;
}
} // namespace

class SmallSteps : public testing::TestWithParam<double>
{
};

TEST_P(SmallSteps, GoWhereTheyAreSmallerThanTheTolerance)
{
  const TetrahedralMesh block = BlockWithStep(GetParam());
  for (const double length : { 0.0, 150.0 })
  {
    const RefinedMesh refined = Refined(block, Remeshed(length));
    ExpectRemeshingLaws(block, {}, refined, Tolerance);
    EXPECT_GT(ShortestEdge(refined), 10 * Tolerance);
    EXPECT_GT(LeastSines(refined.Points, refined.Cells).front(), std::sin(0.05));
    EXPECT_LT(refined.Cells.size(), 3000U);
  }
}

TEST_P(SmallSteps, StayWhereTheyAreALabelOfTheirOwn)
{
  const TetrahedralMesh block = BlockWithStep(GetParam());
  const RefinementParameters parameters = RemeshedWithLabelOfStep(block);
  const RefinedMesh refined = Refined(block, parameters);
  ExpectRemeshingLaws(block, {}, refined, Tolerance);
  std::ptrdiff_t ofStep = 0;
  for (const std::array<Id, 4>& faces : refined.OriginalFaces)
  {
    ofStep += std::count_if(faces.begin(), faces.end(),
      [&](Id face) { return face != None && parameters.Labels[face / 4][face % 4] == 1; });
  }
  EXPECT_GT(ofStep, 0);
}

INSTANTIATE_TEST_SUITE_P(Heights, SmallSteps, testing::Values(0.5, 0.01, 1e-4, 1e-7));

TEST(SmallSteps, StayWhereTheyAreLargerThanTheTolerance)
{
  const TetrahedralMesh block = BlockWithStep(20);
  const RefinedMesh refined = Refined(block, Remeshed(150));
  ExpectRemeshingLaws(block, {}, refined, Tolerance);
  EXPECT_LE(ShortestEdge(refined), 20.5);
}

TEST(SmallSteps, GoWhereTheirAreaIsARoundingErrorThoughTheyAreALabelOfTheirOwn)
{
  const TetrahedralMesh block = BlockWithStep(1e-11);
  const RefinedMesh refined = Refined(block, RemeshedWithLabelOfStep(block));
  EXPECT_GT(ShortestEdge(refined), 10 * Tolerance);
}

TEST(SmallSteps, GoWhereTheSurfaceIsMendedAndTheRestStays)
{
  const TetrahedralMesh block = BlockWithStep(1e-7);
  RefinementParameters parameters;
  ASSERT_LT(ShortestEdge(Refined(block, parameters)), 1e-6);
  parameters.MendsSurface = [](const RefinedMesh&) { return true; };
  const RefinedMesh refined = Refined(block, parameters);
  ExpectRemeshingLaws(block, {}, refined, RefinementParameters::MendingTolerance * 100 * Size);
  EXPECT_GT(ShortestEdge(refined), 1);
  for (std::size_t c = 0; c < refined.Cells.size(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      for (const Id corner : FaceOf(refined.Cells[c], k))
      {
        EXPECT_TRUE(refined.OriginalFaces[c][k] == None || refined.OriginalPoints[corner] != None);
      }
    }
  }
}

TEST(SmallSteps, AreMendedInTheResultWhereTheyAreFew)
{
  TetrahedralMesh block = EvenGrid(Size);
  const Point amid = { { 200, 200, 100 * Size } };
  *std::find(block.Points.begin(), block.Points.end(), amid) = { { 100 + 1e-7, 200, 100 * Size } };
  RefinementParameters parameters;
  parameters.Sizes.LengthOfCell.assign(block.Cells.size(), 20);
  std::vector<RefinedMesh> results;
  parameters.MendsSurface = [&results](const RefinedMesh& result)
  {
    results.push_back(result);
    return results.size() == 1;
  };
  Refined(block, parameters);
  ASSERT_EQ(results.size(), 2U);
  EXPECT_LT(ShortestEdge(results[0]), 1e-6);
  EXPECT_GT(ShortestEdge(results[1]), 1e-3);
  ExpectRemeshingLaws(block, {}, results[1], RefinementParameters::MendingTolerance * 100 * Size);
  std::vector<Point> common;
  for (RefinedMesh& result : results)
  {
    std::sort(result.Points.begin(), result.Points.end());
  }
  std::set_intersection(results[0].Points.begin(), results[0].Points.end(),
    results[1].Points.begin(), results[1].Points.end(), std::back_inserter(common));
  EXPECT_GT(common.size(), results[0].Points.size() * 3 / 4);
}

TEST(SmallSteps, ThatWouldTakeALabelsAreaAlongStayWhereTheSurfaceIsMended)
{
  const TetrahedralMesh block = BlockWithStep(1e-5);
  RefinementParameters parameters = RemeshedWithLabelOfStep(block);
  parameters.Surface = SurfaceTreatment::Kept;
  parameters.MendsSurface = [](const RefinedMesh&) { return true; };
  parameters.Sizes.EdgeLength = 0;
  const RefinedMesh refined = Refined(block, parameters);
  EXPECT_LT(ShortestEdge(refined), 2e-5);
}
