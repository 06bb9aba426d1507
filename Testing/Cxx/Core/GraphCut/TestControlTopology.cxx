// SPDX-License-Identifier: GPL-3.0-or-later
#include "GraphCut/SegmentMesh.h"

#include "GraphCut/InteriorFaces.h"
#include "HullMesh.h"
#include "Support/CutReference.h"
#include "Support/Homology.h"
#include "Support/StopAtEveryReport.h"
#include "Support/TestMeshes.h"
#include "Support/TestTetrahedra.h"

#include <gtest/gtest.h>

#include <numeric>

namespace
{
using namespace insideout;
using testhomology::ByHomology;
using testhomology::Simplex;
using testtetrahedra::Cubes;
using testtetrahedra::EvenGrid;
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

double VolumeOf(const TetrahedralMesh& mesh, Id cell)
{
  std::array<std::array<double, 3>, 3> d;
  for (int k = 0; k < 3; ++k)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      d[k][axis] =
        mesh.Points[mesh.Cells[cell][k + 1]][axis] - mesh.Points[mesh.Cells[cell][0]][axis];
    }
  }
  return std::abs(d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
           d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
           d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0])) /
    6;
}

/** The parts that whole faces join, by a union-find on the points of faces alone. */
class Parts
{
public:
  Parts(const TetrahedralMesh& mesh, const std::vector<unsigned char>& labels, unsigned char label)
    : Parents(labels.size())
  {
    std::iota(this->Parents.begin(), this->Parents.end(), 0);
    std::map<std::set<Id>, Id> firstOfFace;
    for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
    {
      for (int k = 0; k < 4; ++k)
      {
        std::set<Id> face(mesh.Cells[cell].begin(), mesh.Cells[cell].end());
        face.erase(mesh.Cells[cell][k]);
        ++this->CellsOfFace[face];
        if (labels[cell] == label)
        {
          const auto [found, isNew] = firstOfFace.insert({ face, cell });
          this->Parents[this->Find(cell)] = this->Find(found->second);
        }
      }
    }
    for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
    {
      if (labels[cell] == label)
      {
        Part& part = this->ByRoot[this->Find(cell)];
        part.Volume += VolumeOf(mesh, cell);
        part.Cells.push_back(cell);
        for (int k = 0; k < 4; ++k)
        {
          std::set<Id> face(mesh.Cells[cell].begin(), mesh.Cells[cell].end());
          face.erase(mesh.Cells[cell][k]);
          part.IsOnHull = part.IsOnHull || this->CellsOfFace[face] == 1;
        }
      }
    }
  }

  struct Part
  {
    double Volume = 0;
    bool IsOnHull = false;
    std::vector<Id> Cells;
  };

  std::vector<Part> BySize() const
  {
    std::vector<Part> parts;
    for (const auto& [root, part] : this->ByRoot)
    {
      parts.push_back(part);
    }
    std::sort(
      parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.Volume > b.Volume; });
    return parts;
  }

private:
  Id Find(Id i)
  {
    return this->Parents[i] == i ? i : this->Parents[i] = this->Find(this->Parents[i]);
  }

  std::vector<Id> Parents;
  std::map<std::set<Id>, int> CellsOfFace;
  std::map<Id, Part> ByRoot;
};

BettiNumbers BettiOf(const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside)
{
  std::vector<Simplex> cells;
  for (std::size_t cell = 0; cell < inside.size(); ++cell)
  {
    if (inside[cell])
    {
      cells.emplace_back(mesh.Cells[cell].begin(), mesh.Cells[cell].end());
    }
  }
  return ByHomology(cells);
}

/** A mesh with winding numbers. */
struct Case
{
  TetrahedralMesh Mesh;
  std::vector<double> W;
};

/** Winding numbers that make many parts and holes; some faces are facets. */
Case RandomCase(unsigned seed, int size)
{
  Case made = { Grid(seed, size), {} };
  std::mt19937 random(seed);
  testtetrahedra::RandomFaces(made.Mesh, seed);
  for (Id cell = 0; cell < made.Mesh.NumberOfCells(); ++cell)
  {
    made.W.push_back(random() % 3 == 0 ? 1.0 : static_cast<double>(random() % 1000) / 2500);
  }
  return made;
}

template <typename Predicate>
Case CubesCase(int size, const Predicate& isInside)
{
  Case made = { EvenGrid(size), {} };
  const std::vector<unsigned char> inside = Cubes(made.Mesh, isInside);
  made.W.assign(inside.begin(), inside.end());
  return made;
}

MeshSegmentation Solve(
  const Case& made, const SegmentMeshParameters& parameters, const std::vector<Seed>& seeds = {})
{
  Monitor monitor;
  return SegmentMesh(made.Mesh, made.W, PiecesOfFacets(made.Mesh), seeds, parameters, monitor);
}

SegmentMeshParameters AskFor(TopologyGoal goal)
{
  SegmentMeshParameters parameters;
  parameters.Topology.Goal = goal;
  return parameters;
}

int CountUnsatisfied(const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside)
{
  int count = 0;
  for (const FacetPiece& piece : PiecesOfFacets(mesh))
  {
    count += !inside[piece.First] && (piece.Second == None || !inside[piece.Second]);
  }
  return count;
}
} // namespace

TEST(ChooseRegions, KeepsTheLargestAndThoseThatAreLargeEnough)
{
  for (unsigned seed = 0; seed < 10; ++seed)
  {
    const Case made = RandomCase(seed, 3);
    const std::vector<Parts::Part> all = Parts(made.Mesh, Solve(made, {}).Inside, 1).BySize();
    ASSERT_GT(all.size(), 3u);
    SegmentMeshParameters largest;
    largest.Topology.Regions.LargestRegions = 2;
    SegmentMeshParameters large;
    large.Topology.Regions.MinimumRegionVolume = all[2].Volume;
    for (const auto& [parameters, count] :
      { std::make_pair(largest, std::size_t(2)), std::make_pair(large, std::size_t(3)) })
    {
      const MeshSegmentation chosen = Solve(made, parameters);
      const std::vector<Parts::Part> left = Parts(made.Mesh, chosen.Inside, 1).BySize();
      ASSERT_GE(left.size(), count); // of equal volumes more may be large enough
      for (std::size_t k = 0; k < left.size(); ++k)
      {
        EXPECT_NEAR(left[k].Volume, all[k].Volume, 1e-9 * all[k].Volume);
      }
      double dropped = 0;
      for (std::size_t k = left.size(); k < all.size(); ++k)
      {
        dropped += all[k].Volume;
      }
      EXPECT_EQ(StatisticOf(chosen, "DroppedRegions"), all.size() - left.size());
      EXPECT_NEAR(StatisticOf(chosen, "DroppedVolume"), dropped, 1e-9 * dropped);
      EXPECT_GT(StatisticOf(chosen, "Energy"), StatisticOf(chosen, "EnergyOfCut"));
    }
  }
}

TEST(ChooseRegions, KeepsTheSameInAnyUnit)
{
  const Case made = CubesCase(4, [](int i, int, int) { return i == 0 || i > 1; });
  SegmentMeshParameters largest;
  largest.Topology.Regions.LargestRegions = 1;
  const std::vector<unsigned char> expected = Solve(made, largest).Inside;
  EXPECT_EQ(Parts(made.Mesh, expected, 1).BySize().front().Cells.size(),
    Parts(made.Mesh, Solve(made, {}).Inside, 1).BySize().front().Cells.size());
  for (const int exponent : { -400, 400 }) // where volumes vanish, or overflow
  {
    Case scaled = made;
    for (Point& point : scaled.Mesh.Points)
    {
      for (double& x : point)
      {
        x = std::ldexp(x, exponent);
      }
    }
    EXPECT_EQ(Solve(scaled, largest).Inside, expected) << exponent;
  }
}

TEST(ChooseRegions, KeepsThoseWithASeedInside)
{
  const Case made = CubesCase(5, [](int i, int j, int k) { return i % 2 == 0 && j < 2 && k < 2; });
  SegmentMeshParameters parameters;
  parameters.Topology.Regions.SeededRegions = true;
  const std::vector<Seed> seeds = { { { { 250, 50, 50 } }, true }, { { { 50, 50, 50 } }, false } };
  const MeshSegmentation seeded = Solve(made, parameters, seeds);
  const std::vector<Parts::Part> left = Parts(made.Mesh, seeded.Inside, 1).BySize();
  ASSERT_EQ(left.size(), 1u);
  EXPECT_NEAR(left[0].Volume, 4e6, 1e-3);
  EXPECT_EQ(StatisticOf(seeded, "DroppedRegions"), 2);
  const MeshSegmentation none = Solve(made, parameters);
  EXPECT_EQ(std::count(none.Inside.begin(), none.Inside.end(), 1), 0);
  EXPECT_EQ(StatisticOf(none, "DroppedRegions"), 3);
  ASSERT_EQ(none.Warnings.size(), 1u);
  EXPECT_NE(none.Warnings[0].find("all 3 regions of the solid were dropped"), std::string::npos);
}

TEST(ChooseRegions, FillsCavitiesAndNothingElse)
{
  int filled = 0;
  for (unsigned seed = 0; seed < 10; ++seed)
  {
    Case made = RandomCase(seed, 3);
    for (double& w : made.W)
    {
      w = 1 - w; // mostly inside
    }
    SegmentMeshParameters parameters;
    parameters.Topology.Regions.FillCavities = true;
    const std::vector<unsigned char> before = Solve(made, {}).Inside;
    const MeshSegmentation after = Solve(made, parameters);
    double volume = 0;
    int cavities = 0;
    for (const Parts::Part& hole : Parts(made.Mesh, before, 0).BySize())
    {
      for (const Id cell : hole.Cells)
      {
        EXPECT_EQ(after.Inside[cell], hole.IsOnHull ? 0 : 1);
      }
      cavities += !hole.IsOnHull;
      volume += hole.IsOnHull ? 0 : hole.Volume;
    }
    EXPECT_EQ(StatisticOf(after, "FilledCavities"), cavities);
    EXPECT_NEAR(StatisticOf(after, "FilledVolume"), volume, 1e-9 * volume);
    EXPECT_EQ(BettiOf(made.Mesh, after.Inside).Cavities, 0);
    filled += cavities;
  }
  EXPECT_GT(filled, 10);
}

TEST(ChooseRegions, RefusesWhatIsNoChoice)
{
  const Case made = RandomCase(0, 1);
  SegmentMeshParameters parameters;
  parameters.Topology.Regions.MinimumRegionVolume = std::nan("");
  EXPECT_THROW(Solve(made, parameters), Error);
  parameters.Topology.Regions = {};
  parameters.Topology.Regions.LargestRegions = -1;
  EXPECT_THROW(Solve(made, parameters), Error);
}

TEST(ConnectRegions, GivesOnePartForNoLessEnergyThanTheCut)
{
  double joined = 0;
  double dropped = 0;
  for (unsigned seed = 0; seed < 12; ++seed)
  {
    const Case made = RandomCase(seed, 3);
    for (const bool facets : { false, true })
    {
      for (const bool manifold : { false, true })
      {
        SegmentMeshParameters parameters = AskFor(TopologyGoal::OneComponent);
        parameters.ConstrainFacets = facets;
        parameters.FillNonManifold = manifold;
        const MeshSegmentation one = Solve(made, parameters);
        EXPECT_EQ(Parts(made.Mesh, one.Inside, 1).BySize().size(), 1u);
        EXPECT_TRUE(one.Warnings.empty());
        const double energy =
          testcut::EnergyOf({ made.W, InteriorFaces(made.Mesh), {}, {} }, {}, one.Inside);
        EXPECT_NEAR(StatisticOf(one, "Energy"), energy, 1e-9 * energy);
        EXPECT_GE(energy, StatisticOf(one, "EnergyOfCut") * (1 - 1e-12));
        EXPECT_GE(
          StatisticOf(one, "EnergyBeforeTopology"), StatisticOf(one, "EnergyOfCut") * (1 - 1e-12));
        EXPECT_TRUE(!facets || CountUnsatisfied(made.Mesh, one.Inside) == 0);
        if (manifold)
        {
          const testcut::NotManifold bad = testcut::CountNotManifold(made.Mesh.Cells, one.Inside);
          EXPECT_EQ(bad.Edges + bad.Points, 0);
        }
        joined += StatisticOf(one, "JoinedRegions");
        dropped += StatisticOf(one, "DroppedRegions");
      }
    }
  }
  EXPECT_GT(joined, 50);
  EXPECT_GT(dropped, 50);
}

/** Against all labellings of six cells that are one part. */
TEST(ConnectRegions, IsNearTheLeastEnergyOfSmallMeshes)
{
  int least = 0;
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    Case made = { Grid(seed, 1), {} };
    std::mt19937 random(seed);
    for (int cell = 0; cell < 6; ++cell)
    {
      made.W.push_back(cell % 2 == 0 ? 1 : static_cast<double>(random() % 1000) / 1000);
    }
    const CellGraph graph = { made.W, InteriorFaces(made.Mesh), {}, {} };
    double best = std::numeric_limits<double>::infinity();
    for (unsigned set = 1; set < 64; ++set)
    {
      std::vector<unsigned char> labels;
      for (int cell = 0; cell < 6; ++cell)
      {
        labels.push_back(set >> cell & 1u);
      }
      if (Parts(made.Mesh, labels, 1).BySize().size() == 1)
      {
        best = std::min(best, testcut::EnergyOf(graph, {}, labels));
      }
    }
    const MeshSegmentation one = Solve(made, AskFor(TopologyGoal::OneComponent));
    EXPECT_GE(StatisticOf(one, "Energy"), best * (1 - 1e-12));
    EXPECT_LE(StatisticOf(one, "Energy"), 2 * best);
    least += StatisticOf(one, "Energy") <= best * (1 + 1e-12);
  }
  EXPECT_GE(least, 50);
}

TEST(ConnectRegions, JoinsWhatIsNearAndDropsWhatIsSmall)
{
  // Two blocks, a cube apart, and a single tetrahedron of another cube far away.
  Case made = CubesCase(5, [](int i, int j, int k) { return i != 2 && j < 2 && k < 2; });
  made.W.back() = 1;
  const MeshSegmentation one = Solve(made, AskFor(TopologyGoal::OneComponent));
  EXPECT_EQ(Parts(made.Mesh, one.Inside, 1).BySize().size(), 1u);
  EXPECT_EQ(StatisticOf(one, "JoinedRegions"), 1);
  EXPECT_EQ(StatisticOf(one, "DroppedRegions"), 1);
  EXPECT_NEAR(StatisticOf(one, "DroppedVolume"), 1e6 / 6, 1e-3);
  EXPECT_EQ(one.Inside.back(), 0);
  EXPECT_GT(std::count(one.Inside.begin(), one.Inside.end(), 1), 16 * 6);
}

TEST(ConnectRegions, SaysWhatSeedsForbid)
{
  // A wall of cells that are to be outside stands between two cubes that are to be inside.
  const Case made = CubesCase(3, [](int i, int, int) { return i != 1; });
  std::vector<Seed> seeds;
  for (Id cell = 0; cell < made.Mesh.NumberOfCells(); ++cell)
  {
    Point middle = { { 0, 0, 0 } };
    for (const Id p : made.Mesh.Cells[cell])
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        middle[axis] += made.Mesh.Points[p][axis] / 4;
      }
    }
    seeds.push_back({ middle, made.W[cell] == 1 });
  }
  const MeshSegmentation parted = Solve(made, AskFor(TopologyGoal::OneComponent), seeds);
  EXPECT_EQ(Parts(made.Mesh, parted.Inside, 1).BySize().size(), 2u);
  ASSERT_EQ(parted.Warnings.size(), 1u);
  EXPECT_NE(parted.Warnings[0].find("not one component but 2"), std::string::npos);
}

TEST(SimplyConnect, MakesABallOfRingsAndHollowBlocks)
{
  const auto within = [](int i) { return i > 0 && i < 4; };
  const std::vector<Case> cases = { // a ring, a hollow block, and two rings apart
    CubesCase(5,
      [&](int i, int j, int k) { return within(i) && within(j) && k == 2 && !(i == 2 && j == 2); }),
    CubesCase(5,
      [&](int i, int j, int k)
      { return within(i) && within(j) && within(k) && !(i == 2 && j == 2 && k == 2); }),
    CubesCase(
      5, [&](int i, int j, int k) { return i < 3 && j < 3 && k % 3 == 0 && !(i == 1 && j == 1); })
  };
  for (const Case& made : cases)
  {
    const MeshSegmentation ball = Solve(made, AskFor(TopologyGoal::SimplyConnected));
    const BettiNumbers betti = BettiOf(made.Mesh, ball.Inside);
    EXPECT_EQ(betti.Components, 1);
    EXPECT_EQ(betti.Tunnels, 0);
    EXPECT_EQ(betti.Cavities, 0);
    EXPECT_EQ(Parts(made.Mesh, ball.Inside, 1).BySize().size(), 1u);
    EXPECT_TRUE(ball.Warnings.empty());
    EXPECT_GT(StatisticOf(ball, "Energy"), StatisticOf(ball, "EnergyOfCut"));
  }
}

/** Here a tunnel and a cavity of what no cell fills, which leave Euler's number as a ball's is. */
TEST(SimplyConnect, KnowsHolesOfCellsThatFillNoConvexHull)
{
  const Case whole = CubesCase(
    5, [](int i, int j, int k) { return !(i == 3 && j == 3) && !(i == 1 && j == 1 && k == 2); });
  Case part;
  part.Mesh.Points = whole.Mesh.Points;
  std::vector<Id> newIds(whole.W.size(), None);
  for (Id cell = 0; cell < whole.Mesh.NumberOfCells(); ++cell)
  {
    if (whole.W[cell] == 1)
    {
      newIds[cell] = part.Mesh.NumberOfCells();
      part.Mesh.Cells.push_back(whole.Mesh.Cells[cell]);
      part.Mesh.Neighbors.push_back(whole.Mesh.Neighbors[cell]);
      part.Mesh.Facets.push_back({ None, None, None, None });
      part.W.push_back(1);
    }
  }
  for (std::array<Id, 4>& neighbors : part.Mesh.Neighbors)
  {
    for (Id& neighbor : neighbors)
    {
      neighbor = neighbor == None ? None : newIds[neighbor];
    }
  }
  const BettiNumbers before = BettiOf(part.Mesh, Solve(part, {}).Inside);
  ASSERT_EQ(before.Tunnels, 1);
  ASSERT_EQ(before.Cavities, 1);
  const MeshSegmentation ball = Solve(part, AskFor(TopologyGoal::SimplyConnected));
  const BettiNumbers betti = BettiOf(part.Mesh, ball.Inside);
  EXPECT_EQ(betti.Components, 1);
  EXPECT_EQ(betti.Tunnels, 0);
  EXPECT_EQ(betti.Cavities, 0);
  EXPECT_TRUE(ball.Warnings.empty());
}

/** Across a narrow hole that is long comes a membrane, through a thin ring around a wide one a
 * wall.
 */
TEST(SimplyConnect, TakesTheWayOfLessEnergy)
{
  const auto within = [](int i) { return i > 0 && i < 4; };
  const Case narrow = CubesCase(5,
    [&](int i, int j, int k) { return within(i) && within(j) && within(k) && (i != 2 || j != 2); });
  const Case wide =
    CubesCase(5, [&](int i, int j, int k) { return k == 2 && !(within(i) && within(j)); });
  for (const Case* made : { &narrow, &wide })
  {
    const MeshSegmentation ball = Solve(*made, AskFor(TopologyGoal::SimplyConnected));
    Id added = 0;
    Id removed = 0;
    for (std::size_t cell = 0; cell < made->W.size(); ++cell)
    {
      added += ball.Inside[cell] > made->W[cell];
      removed += ball.Inside[cell] < made->W[cell];
    }
    EXPECT_EQ(made == &narrow ? removed : added, 0);
    EXPECT_GT(added + removed, 0);
    EXPECT_LE(added + removed, 6);
  }
}

/** Each hole in its own way: a block with a narrow hole, in the frame of a thin ring. */
TEST(SimplyConnect, FillsOneHoleAndCutsAnotherOpen)
{
  const auto isBlock = [](int i, int j, int k)
  { return i < 3 && j < 3 && k < 3 && !(i == 1 && j == 1); };
  const auto isRing = [](int i, int j, int k)
  { return k == 1 && i >= 2 && (i == 2 || i == 6 || j == 0 || j == 4) && j < 5; };
  const Case made =
    CubesCase(7, [&](int i, int j, int k) { return isBlock(i, j, k) || isRing(i, j, k); });
  ASSERT_EQ(BettiOf(made.Mesh, Solve(made, {}).Inside).Tunnels, 2);
  const MeshSegmentation ball = Solve(made, AskFor(TopologyGoal::SimplyConnected));
  EXPECT_EQ(BettiOf(made.Mesh, ball.Inside).Tunnels, 0);
  Id added = 0;
  Id removed = 0;
  for (std::size_t cell = 0; cell < made.W.size(); ++cell)
  {
    added += ball.Inside[cell] > made.W[cell];
    removed += ball.Inside[cell] < made.W[cell];
  }
  EXPECT_GT(added, 0);
  EXPECT_LE(added, 6);
  EXPECT_GT(removed, 0);
  EXPECT_LE(removed, 6);
}

TEST(SimplyConnect, KeepsItsPromiseOrSaysThatItDoesNot)
{
  int balls = 0;
  for (unsigned seed = 0; seed < 12; ++seed)
  {
    const Case made = RandomCase(seed, 3);
    for (const bool manifold : { false, true })
    {
      SegmentMeshParameters parameters = AskFor(TopologyGoal::SimplyConnected);
      parameters.FillNonManifold = manifold;
      const MeshSegmentation one = Solve(made, parameters);
      const BettiNumbers betti = BettiOf(made.Mesh, one.Inside);
      const bool isBall = betti.Components == 1 && betti.Tunnels == 0 && betti.Cavities == 0;
      EXPECT_EQ(isBall, one.Warnings.empty());
      EXPECT_EQ(Parts(made.Mesh, one.Inside, 1).BySize().size(), 1u);
      EXPECT_GE(StatisticOf(one, "Energy"), StatisticOf(one, "EnergyOfCut") * (1 - 1e-12));
      EXPECT_TRUE(isBall || manifold);
      balls += isBall;
    }
  }
  EXPECT_GE(balls, 12);
}

TEST(ControlTopology, StopsAtEveryReport)
{
  const Case made = RandomCase(3, 3);
  const CellGraph graph = { made.W, InteriorFaces(made.Mesh), {}, {} };
  const CutEnergy energy{ RealEnergy(graph, {}) };
  const std::vector<unsigned char> labels = MinimumCut(energy);
  const SimplicialCells cells(made.Mesh.Points.size(), made.Mesh.Cells, made.Mesh.Neighbors,
    { { 2, 0, 1, 3 } },
    [&]() {
      return ScaledSizes{ std::vector<double>(labels.size(), 1.0), 0 };
    });
  ControlTopologyParameters parameters;
  parameters.Goal = TopologyGoal::SimplyConnected;
  parameters.Regions.LargestRegions = 20;
  parameters.Regions.FillCavities = true;
  const int reports = testmeshes::StopAtEveryReport(
    [&](Monitor& monitor, const ProgressRange& range)
    {
      std::vector<unsigned char> inside = labels;
      ControlTopology(
        cells, energy, { &graph.Demands, nullptr, {} }, parameters, inside, monitor, range);
    });
  EXPECT_GT(reports, 10);
}
