// SPDX-License-Identifier: GPL-3.0-or-later
#include "Quality/SolverFitness.h"

#include "Support/TestTetrahedra.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace insideout;
using testtetrahedra::EvenGrid;
using testtetrahedra::Flatten;
using testtetrahedra::Grid;

SolverFitness FitnessOf(const std::vector<Point>& points, const std::vector<Tetrahedron>& cells,
  const std::vector<std::array<Id, 6>>& midpoints = {}, const std::vector<Id>& regions = {},
  const LayerCells& layers = {})
{
  Monitor silent;
  return FitnessForSolver(points, cells, midpoints, layers, regions, silent, { "measuring", 0, 1 });
}

/** A cell whose corner at the top is as high as this above the middle of the others. */
std::vector<Point> CellOfHeight(double height)
{
  return { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0.25, 0.25, height } } };
}
const std::vector<Tetrahedron> OneCell = { { { 0, 1, 2, 3 } } };

/** The cell with mid-edge nodes. */
std::vector<Point> WithMidpoints(std::vector<Point> points)
{
  for (const auto& [i, j] : TetrahedronEdges)
  {
    Point middle;
    for (int k = 0; k < 3; ++k)
    {
      middle[k] = (points[i][k] + points[j][k]) / 2;
    }
    points.push_back(middle);
  }
  return points;
}
const std::vector<std::array<Id, 6>> ItsMidpoints = { { { 4, 5, 6, 7, 8, 9 } } };
} // namespace

TEST(SolverFitness, OfAGridIsGood)
{
  const TetrahedralMesh mesh = Grid(2, 4);
  const SolverFitness fitness = FitnessOf(mesh.Points, mesh.Cells);
  EXPECT_TRUE(fitness.IsGood());
  EXPECT_EQ(fitness.Cells, mesh.NumberOfCells());
  EXPECT_EQ(WordsOfFitness(fitness, CellTreatment::None), "");
}

TEST(SolverFitness, CountsCellsThatAreFlatInDoublesThoughTheyArePositive)
{
  TetrahedralMesh mesh = EvenGrid(4);
  for (Point& point : mesh.Points)
  {
    for (double& x : point)
    {
      x /= 700; // which rounds
    }
  }
  EXPECT_TRUE(FitnessOf(mesh.Points, mesh.Cells).IsGood());
  ASSERT_GT(Flatten(mesh, 3), 0);
  ASSERT_TRUE(testtetrahedra::AllPositive(mesh));
  const SolverFitness fitness = FitnessOf(mesh.Points, mesh.Cells);
  EXPECT_GT(fitness.RefusedCells, 0);
  EXPECT_EQ(fitness.TooSmallCells, 0);
}

TEST(SolverFitness, TakesPrismsAtTheirIntegrationPoints)
{
  const LayerCells prism = { {}, { { { 0, 1, 2, 3, 4, 5 } } } };
  std::vector<Point> points = { { { 0, 0, 0 } }, { { 0, 1, 0 } }, { { 1, 0, 0 } }, { { 0, 0, 1 } },
    { { 0, 1, 1 } }, { { 1, 0, 1 } } };
  const auto refused = [&] { return FitnessOf(points, {}, {}, {}, prism).RefusedCells; };
  EXPECT_EQ(refused(), 0);
  EXPECT_EQ(FitnessOf(points, {}, {}, {}, prism).Cells, 1);
  // The second triangle turns over as it gets less wide; the point there is at 0.789 of the way.
  points[4][1] = points[5][0] = -0.1;
  EXPECT_EQ(refused(), 0);
  points[4][1] = -0.6;
  points[5][0] = 1;
  EXPECT_EQ(refused(), 1);
  const LayerCells pyramid = { { { { 1, 2, 5, 4, 0 } } }, {} };
  points[4][1] = 1;
  EXPECT_EQ(FitnessOf(points, {}, {}, {}, pyramid).RefusedCells, 0);
  const LayerCells turned = { { { { 1, 4, 5, 2, 0 } } }, {} };
  EXPECT_EQ(FitnessOf(points, {}, {}, {}, turned).RefusedCells, 1);
  for (Point& point : points)
  {
    point = { { 1e-7 * point[0], 1e-7 * point[1], 1e-7 * point[2] } };
  }
  EXPECT_EQ(FitnessOf(points, {}, {}, {}, prism).TooSmallCells, 1);
}

TEST(SolverFitness, TellsRefusedFromPoorAndGoodByTheHeight)
{
  const auto counts = [](double height)
  {
    const SolverFitness fitness = FitnessOf(CellOfHeight(height), OneCell);
    return std::array<Id, 2>{ fitness.RefusedCells, fitness.PoorCells };
  };
  EXPECT_EQ(counts(-1), (std::array<Id, 2>{ 1, 0 }));
  EXPECT_EQ(counts(0), (std::array<Id, 2>{ 1, 0 }));
  EXPECT_EQ(counts(1e-21), (std::array<Id, 2>{ 1, 0 }));
  EXPECT_EQ(counts(1e-19), (std::array<Id, 2>{ 0, 1 }));
  // The face opposite to corner 1 or 2 is nearest to the ground: a height of 1/4 from its edge.
  const double tangent = std::tan(std::acos(-1.0) / 180);
  EXPECT_EQ(counts(0.99 * 0.25 * tangent), (std::array<Id, 2>{ 0, 1 }));
  EXPECT_EQ(counts(1.5 * 0.25 * tangent), (std::array<Id, 2>{ 0, 0 }));
}

TEST(SolverFitness, CountsNearlyFlatCellsInAnyUnit)
{
  const auto fitnessOf = [](double height, double unit)
  {
    std::vector<Point> points = CellOfHeight(height);
    for (Point& p : points)
    {
      p = { { unit * p[0], unit * p[1], unit * p[2] } };
    }
    return FitnessOf(points, OneCell);
  };
  for (const double unit : { 1e3, 1.0, 1e-2 })
  {
    const SolverFitness flat = fitnessOf(1e-13, unit);
    EXPECT_EQ(flat.NearlyFlatCells, 1);
    EXPECT_EQ(flat.PoorCells, 1);
    EXPECT_EQ(flat.UnfitCells(), 1);
    EXPECT_NE(
      WordsOfFitness(flat, CellTreatment::None).find("half its digits at 1 "), std::string::npos);
    EXPECT_EQ(fitnessOf(1e-9, unit).NearlyFlatCells, 1);
    EXPECT_EQ(fitnessOf(1e-7, unit).NearlyFlatCells, 0);
  }
  const SolverFitness refused = fitnessOf(1e-13, 1e-7);
  EXPECT_EQ(refused.RefusedCells, 1);
  EXPECT_EQ(refused.TooSmallCells, 0) << "it would be as flat in another unit";
  EXPECT_EQ(refused.UnfitCells(), 1);
}

TEST(SolverFitness, TakesTheUnitIntoAccount)
{
  std::vector<Point> points = CellOfHeight(0.5);
  for (Point& point : points)
  {
    for (double& x : point)
    {
      x *= 1e-7; // a tenth of a micrometer in meters: six volumes are 5e-22
    }
  }
  const SolverFitness fitness = FitnessOf(points, OneCell);
  EXPECT_EQ(fitness.RefusedCells, 1);
  EXPECT_EQ(fitness.TooSmallCells, 1);
  EXPECT_NE(WordsOfFitness(fitness, CellTreatment::None).find("(by scale)"), std::string::npos);
  EXPECT_EQ(WordsOfFitness(fitness, CellTreatment::None).find("Refine"), std::string::npos);
}

TEST(SolverFitness, LooksAtTheIntegrationPointsOfQuadraticCells)
{
  const std::vector<Point> straight = WithMidpoints(CellOfHeight(0.5));
  EXPECT_TRUE(FitnessOf(straight, OneCell, ItsMidpoints).IsGood());
  constexpr std::array<std::size_t, 6> opposite = { { 5, 3, 4, 1, 2, 0 } };
  for (std::size_t edge = 0; edge < 6; ++edge)
  {
    std::vector<Point> curved = straight; // far beyond the opposite edge
    for (int k = 0; k < 3; ++k)
    {
      curved[4 + edge][k] += 3 * (straight[4 + opposite[edge]][k] - straight[4 + edge][k]);
    }
    EXPECT_TRUE(FitnessOf(curved, OneCell).IsGood());
    EXPECT_TRUE(
      FitnessOf(curved, OneCell, { { { None, None, None, None, None, None } } }).IsGood());
    EXPECT_EQ(FitnessOf(curved, OneCell, ItsMidpoints).RefusedCells, 1) << edge;
  }
  std::vector<Point> swapped = straight; // as gmsh has the last two
  std::swap(swapped[8], swapped[9]);
  EXPECT_EQ(FitnessOf(swapped, OneCell, ItsMidpoints).RefusedCells, 1);
}

TEST(SolverFitness, TellsWhereNeedlesHaveToStay)
{
  // Two cells on either side of a needle, 0 1 2.
  const std::vector<Point> points = { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0.5, 0.001, 0 } },
    { { 0.5, 0, 1 } }, { { 0.5, 0, -1 } } };
  const std::vector<Tetrahedron> cells = { { { 0, 1, 2, 3 } }, { { 0, 2, 1, 4 } } };
  const SolverFitness one = FitnessOf(points, { cells[0] });
  EXPECT_EQ(one.PoorCells, 1);
  EXPECT_EQ(one.CellsOnNeedles, 1);
  EXPECT_EQ(FitnessOf(points, cells, {}, { 0, 1 }).CellsOnNeedles, 2);
  const std::string words = WordsOfFitness(one, CellTreatment::Refined);
  EXPECT_NE(words.find(": they lie on needles of the surface"), std::string::npos) << words;
  EXPECT_NE(words.find("SurfaceTreatment remeshed"), std::string::npos) << words;
  EXPECT_EQ(words.find("Refine"), std::string::npos) << words;
  const std::string kept = WordsOfFitness(one, CellTreatment::Refined, false);
  EXPECT_EQ(kept.find("remeshed"), std::string::npos) << kept;
  EXPECT_NE(kept.find("which other options keep: MergeTolerance"), std::string::npos) << kept;
}

TEST(SolverFitness, AdvisesNothingTwice)
{
  SolverFitness fitness;
  fitness.Cells = 10;
  fitness.RefusedCells = 2;
  fitness.PoorCells = 3;
  const auto words = [&fitness](CellTreatment done) { return WordsOfFitness(fitness, done); };
  EXPECT_EQ(words(CellTreatment::None),
    "a solver refuses 2 of 10 cells, whose Jacobian determinants are below its limit of 1e-20, and "
    "suffers from 3 more, whose dihedral angles are below 1 degree: refining makes better ones "
    "(Refine)");
  EXPECT_NE(words(CellTreatment::Refined).find("SurfaceTreatment remeshed"), std::string::npos);
  EXPECT_NE(words(CellTreatment::Remeshed).find("MergeTolerance"), std::string::npos);
  const std::string kept = WordsOfFitness(fitness, CellTreatment::Refined, false);
  EXPECT_EQ(kept.find("SurfaceTreatment"), std::string::npos);
  EXPECT_NE(kept.find("MergeTolerance"), std::string::npos);
  fitness.RefusedCells = 0;
  EXPECT_EQ(words(CellTreatment::None).rfind("a solver suffers from 3 of 10 cells", 0), 0u);
}
