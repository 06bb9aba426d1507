// SPDX-License-Identifier: GPL-3.0-or-later
#include "GraphCut/SegmentMesh.h"

#include "GraphCut/ConnectCells.h"
#include "GraphCut/InteriorFaces.h"
#include "GraphCut/ManifoldConstraint.h"
#include "HullMesh.h"
#include "Support/CutReference.h"
#include "Support/TestMeshes.h"
#include "Support/TestTetrahedra.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
using namespace insideout;
using testtetrahedra::Grid;

double StatisticOf(const MeshSegmentation& result, const std::string& name)
{
  for (const auto& [key, value] : result.Statistics)
  {
    if (key == name)
    {
      return value;
    }
  }
  ADD_FAILURE() << "no statistic " << name;
  return 0;
}

/** A mesh with winding numbers and facets. */
struct Case
{
  TetrahedralMesh Mesh;
  std::vector<double> W;
};

/** Random faces as facets, and winding numbers that make next to nothing certain. */
Case RandomCase(unsigned seed, int size)
{
  Case made = { Grid(seed, size), {} };
  testtetrahedra::RandomFaces(made.Mesh, seed);
  std::mt19937 random(seed);
  for (Id cell = 0; cell < made.Mesh.NumberOfCells(); ++cell)
  {
    made.W.push_back(static_cast<double>(random() % 1000) / 1000 - 0.2);
  }
  return made;
}

Case HullCase(const TriangleSoup& soup)
{
  Monitor monitor;
  HullMesh hull = MeshHull(soup, {}, monitor);
  return { std::move(hull.Mesh), std::move(hull.W) };
}

/** Random cases, and hulls of random and gridded triangles, which are all holes. */
std::vector<Case> AllCases()
{
  std::vector<Case> cases;
  for (unsigned seed = 0; seed < 12; ++seed)
  {
    cases.push_back(RandomCase(seed, 2 + seed % 3));
  }
  for (unsigned seed = 0; seed < 6; ++seed)
  {
    cases.push_back(HullCase(testmeshes::GridSoup(seed, 30, 3 + seed % 3)));
    cases.push_back(HullCase(testmeshes::RandomSoup(seed, 20)));
  }
  return cases;
}

MeshSegmentation Solve(const Case& made, bool facets, bool manifold,
  const std::vector<Seed>& seeds = {}, const std::vector<FacetPiece>* pieces = nullptr)
{
  Monitor monitor;
  SegmentMeshParameters parameters;
  parameters.ConstrainFacets = facets;
  parameters.FillNonManifold = manifold;
  return SegmentMesh(
    made.Mesh, made.W, pieces ? *pieces : PiecesOfFacets(made.Mesh), seeds, parameters, monitor);
}

int CountUnsatisfied(const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside)
{
  int count = 0;
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    for (int k = 0; k < 4; ++k)
    {
      const Id beyond = mesh.Neighbors[cell][k];
      count += mesh.Facets[cell][k] != None && (beyond == None || beyond > cell) && !inside[cell] &&
        (beyond == None || !inside[beyond]);
    }
  }
  return count;
}

double EnergyOf(const Case& made, const std::vector<unsigned char>& inside)
{
  return testcut::EnergyOf({ made.W, InteriorFaces(made.Mesh), {}, {} }, {}, inside);
}

TEST(FacetConstraint, KeepsEveryPieceOfEveryFacet)
{
  int forced = 0;
  for (const Case& made : AllCases())
  {
    const MeshSegmentation plain = Solve(made, false, false);
    const MeshSegmentation kept = Solve(made, true, false);
    EXPECT_EQ(CountUnsatisfied(made.Mesh, kept.Inside), 0);
    EXPECT_LE(StatisticOf(kept, "ForcedFacets"), CountUnsatisfied(made.Mesh, plain.Inside));
    EXPECT_EQ(StatisticOf(kept, "ForcedFacets") > 0, CountUnsatisfied(made.Mesh, plain.Inside) > 0);
    EXPECT_EQ(StatisticOf(kept, "ForcedCells"), StatisticOf(kept, "ForcedFacets"));
    forced += static_cast<int>(StatisticOf(kept, "ForcedFacets"));
  }
  EXPECT_GT(forced, 500);
}

/** No single cell can change without breaking a constraint or costing energy. */
TEST(FacetConstraint, EndsInALocalMinimumThatIsFeasible)
{
  for (unsigned seed = 0; seed < 12; ++seed)
  {
    const Case made = RandomCase(seed, 3);
    std::vector<unsigned char> inside = Solve(made, true, false).Inside;
    const double energy = EnergyOf(made, inside);
    for (unsigned char& label : inside)
    {
      label = !label;
      EXPECT_TRUE(CountUnsatisfied(made.Mesh, inside) > 0 ||
        EnergyOf(made, inside) >= energy - 1e-9 * energy);
      label = !label;
    }
  }
}

TEST(FacetConstraint, KeepsTheChosenFacetsAlone)
{
  const Case made = RandomCase(3, 3);
  std::vector<unsigned char> chosen;
  for (const std::array<Id, 4>& facets : made.Mesh.Facets)
  {
    for (const Id facet : facets)
    {
      chosen.resize(std::max<std::size_t>(chosen.size(), facet + 1), 0);
    }
  }
  EXPECT_TRUE(PiecesOfFacets(made.Mesh, chosen).empty());
  for (std::size_t f = 0; f < chosen.size(); f += 4)
  {
    chosen[f] = 1;
  }
  const std::vector<FacetPiece> pieces = PiecesOfFacets(made.Mesh, chosen);
  EXPECT_GT(pieces.size(), 0u);
  EXPECT_LT(pieces.size(), PiecesOfFacets(made.Mesh).size() / 2);
  const MeshSegmentation some = Solve(made, true, false, {}, &pieces);
  for (const FacetPiece& piece : pieces)
  {
    EXPECT_EQ(piece.Facet % 4, 0);
    EXPECT_TRUE(
      some.Inside[piece.First] || (piece.Second != None && some.Inside[piece.Second] != 0));
  }
  EXPECT_GT(CountUnsatisfied(made.Mesh, some.Inside), 0);
  EXPECT_LT(
    StatisticOf(some, "ForcedFacets"), StatisticOf(Solve(made, true, false), "ForcedFacets"));
}

TEST(ManifoldConstraint, MakesTheBoundaryAManifold)
{
  int wereNot = 0;
  for (const Case& made : AllCases())
  {
    const testcut::NotManifold before =
      testcut::CountNotManifold(made.Mesh.Cells, Solve(made, false, false).Inside);
    wereNot += before.Edges > 0 || before.Points > 0;
    const MeshSegmentation result = Solve(made, false, true);
    const testcut::NotManifold after = testcut::CountNotManifold(made.Mesh.Cells, result.Inside);
    EXPECT_EQ(after.Edges, 0);
    EXPECT_EQ(after.Points, 0);
    EXPECT_EQ(StatisticOf(result, "NonManifoldPoints"), 0);
    EXPECT_EQ(StatisticOf(result, "ForcedCells") > 0, before.Edges > 0 || before.Points > 0);
  }
  EXPECT_GT(wereNot, 12);
}

TEST(ManifoldConstraint, AndFacetsAreSatisfiedTogether)
{
  for (const Case& made : AllCases())
  {
    const MeshSegmentation result = Solve(made, true, true);
    const testcut::NotManifold after = testcut::CountNotManifold(made.Mesh.Cells, result.Inside);
    EXPECT_EQ(after.Edges, 0);
    EXPECT_EQ(after.Points, 0);
    EXPECT_EQ(CountUnsatisfied(made.Mesh, result.Inside), 0);
  }
}

/** From any labels, as if there were no energy to improve. */
TEST(ManifoldConstraint, IsSatisfiedFromAnyLabelling)
{
  for (unsigned seed = 0; seed < 30; ++seed)
  {
    const Case made = RandomCase(seed, 3);
    std::mt19937 random(seed);
    std::vector<unsigned char> inside;
    for (std::size_t i = 0; i < made.W.size(); ++i)
    {
      inside.push_back(random() % 4 < 1 + seed % 3);
    }
    const CellGraph graph = { made.W, InteriorFaces(made.Mesh), {}, {} };
    const CutEnergy energy{ RealEnergy(graph, {}) };
    GreedyLabels labels(energy, inside);
    ManifoldConstraint manifold(made.Mesh.Points.size(), made.Mesh.Cells, made.Mesh.Neighbors);
    Monitor monitor;
    const ManifoldConstraint::Outcome outcome = manifold.Satisfy(labels, monitor, 0, 1);
    EXPECT_EQ(outcome.LeftPoints, 0);
    EXPECT_GT(outcome.Edges + outcome.Points, 0);
    const testcut::NotManifold after = testcut::CountNotManifold(made.Mesh.Cells, labels.Labels());
    EXPECT_EQ(after.Edges, 0);
    EXPECT_EQ(after.Points, 0);
  }
}

TEST(ManifoldConstraint, LeavesAManifoldAlone)
{
  const Case ball = HullCase(testmeshes::Box({ 0, 0, 0 }, { 1, 2, 3 }));
  const MeshSegmentation result = Solve(ball, true, true);
  EXPECT_EQ(StatisticOf(result, "ChangedCells"), 0);
  EXPECT_EQ(StatisticOf(result, "ForcedCells"), 0);
  EXPECT_EQ(std::count(result.Inside.begin(), result.Inside.end(), 0), 0);
}

/** Two tetrahedra that share an edge only, and nothing between them: what cannot be filled. */
TEST(ManifoldConstraint, CountsWhatAHullThatIsNoneForbids)
{
  const TetrahedralMesh mesh = ConnectCells(
    { { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 1, 1, 0 }, { -1, 0, 0 }, { -1, -1, 0 } },
    { { 0, 1, 2, 3 }, { 0, 1, 4, 5 } });
  const MeshSegmentation result = Solve({ mesh, { 1, 1 } }, false, true);
  EXPECT_EQ(result.Inside, std::vector<unsigned char>({ 1, 1 }));
  EXPECT_EQ(StatisticOf(result, "NonManifoldPoints"), 2);
  ASSERT_EQ(result.Warnings.size(), 1u);
  EXPECT_NE(result.Warnings[0].find("the hull is not manifold there"), std::string::npos);
}

TEST(ManifoldConstraint, NamesCellsThatLieOnOneSideOfAFace)
{
  const TetrahedralMesh mesh =
    ConnectCells({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0, 0, 2 } },
      { { 0, 1, 2, 3 }, { 0, 1, 2, 4 } });
  EXPECT_EQ(Solve({ mesh, { 1, 1 } }, false, false).Inside, std::vector<unsigned char>({ 1, 1 }));
  try
  {
    Solve({ mesh, { 1, 1 } }, false, true);
    ADD_FAILURE();
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::InvalidParameter);
    EXPECT_NE(std::string(error.what()).find("cells 0 and 1 are on one side"), std::string::npos);
  }
}

Point CentreOf(const TetrahedralMesh& mesh, Id cell)
{
  Point centre = { 0, 0, 0 };
  for (const Id p : mesh.Cells[cell])
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      centre[axis] += mesh.Points[p][axis] / 4;
    }
  }
  return centre;
}

TEST(SegmentMesh, ObeysSeedsAndNamesThoseThatForbidAConstraint)
{
  for (unsigned seed = 0; seed < 10; ++seed)
  {
    const Case made = RandomCase(seed, 3);
    std::vector<Seed> seeds;
    for (Id cell = 0; cell < made.Mesh.NumberOfCells(); cell += 2)
    {
      seeds.push_back({ CentreOf(made.Mesh, cell), cell % 4 == 0 });
    }
    const MeshSegmentation result = Solve(made, true, true, seeds);
    for (std::size_t s = 0; s < seeds.size(); ++s)
    {
      EXPECT_EQ(result.Inside[2 * s] != 0, seeds[s].Inside);
    }
    EXPECT_EQ(StatisticOf(result, "UnsatisfiedFacets"), CountUnsatisfied(made.Mesh, result.Inside));
    EXPECT_GT(StatisticOf(result, "UnsatisfiedFacets"), 0);
    EXPECT_GE(StatisticOf(result, "SeedConflicts"), StatisticOf(result, "UnsatisfiedFacets"));
    ASSERT_GE(result.Warnings.size(), 1u);
    EXPECT_NE(result.Warnings[0].find("pieces of facets are not kept"), std::string::npos);
    EXPECT_NE(result.Warnings[0].find("seed "), std::string::npos);
  }
}

TEST(SegmentMesh, SaysTheEnergyBeforeAndAfter)
{
  const Case made = RandomCase(5, 3);
  const MeshSegmentation plain = Solve(made, false, false);
  const MeshSegmentation kept = Solve(made, true, true);
  EXPECT_NEAR(StatisticOf(plain, "Energy"), EnergyOf(made, plain.Inside), 1e-9);
  EXPECT_EQ(StatisticOf(plain, "Energy"), StatisticOf(plain, "EnergyOfCut"));
  EXPECT_EQ(StatisticOf(kept, "EnergyOfCut"), StatisticOf(plain, "Energy"));
  EXPECT_NEAR(StatisticOf(kept, "Energy"), EnergyOf(made, kept.Inside), 1e-9);
  EXPECT_GT(StatisticOf(kept, "Energy"), StatisticOf(kept, "EnergyOfCut"));
  int changed = 0;
  for (std::size_t i = 0; i < made.W.size(); ++i)
  {
    changed += plain.Inside[i] != kept.Inside[i];
  }
  EXPECT_EQ(StatisticOf(kept, "ChangedCells"), changed);
}

TEST(SegmentMesh, StopsAtEveryCheck)
{
  class Stopping : public Monitor
  {
  public:
    bool Continue(const char*, double fraction) override
    {
      EXPECT_GE(fraction, this->Last);
      EXPECT_LE(fraction, 1);
      this->Last = fraction;
      return this->Allowed-- > 0;
    }
    int Allowed = 1000;
    double Last = 0;
  };
  const Case made = RandomCase(1, 3);
  const std::vector<FacetPiece> pieces = PiecesOfFacets(made.Mesh);
  SegmentMeshParameters parameters;
  parameters.ConstrainFacets = parameters.FillNonManifold = true;
  Stopping all;
  const MeshSegmentation whole = SegmentMesh(made.Mesh, made.W, pieces, {}, parameters, all);
  EXPECT_EQ(all.Last, 1);
  const int checks = 1000 - all.Allowed;
  EXPECT_GE(checks, 6);
  for (int allowed = 0; allowed < checks; ++allowed)
  {
    Stopping monitor;
    monitor.Allowed = allowed;
    EXPECT_THROW(SegmentMesh(made.Mesh, made.W, pieces, {}, parameters, monitor), Error);
  }
  Monitor monitor;
  EXPECT_EQ(SegmentMesh(made.Mesh, made.W, pieces, {}, parameters, monitor).Inside, whole.Inside);
}
} // namespace
