// SPDX-License-Identifier: GPL-3.0-or-later
#include "GraphCut/GraphCutSegmentation.h"

#include "Common/Team.h"
#include "GraphCut/CertainCells.h"
#include "GraphCut/InteriorFaces.h"
#include "GraphCut/SegmentMesh.h"
#include "HullMesh.h"
#include "Support/CutReference.h"
#include "Support/TestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <omp.h>
#include <random>
#include <string>

namespace
{
using namespace insideout;

struct Problem : CellGraph
{
  GraphCutParameters Parameters;
};

Segmentation Solve(const Problem& problem)
{
  Monitor monitor;
  return GraphCutSegmentation(problem, problem.Parameters, monitor);
}

double Uniform(std::mt19937& random, double low, double high)
{
  return low + (high - low) * (random() / 4294967296.0);
}

/** Random cells and faces; every pair of cells at most once. */
Problem RandomProblem(unsigned seed, int cells, int faces)
{
  std::mt19937 random(seed);
  Problem problem;
  for (int i = 0; i < cells; ++i)
  {
    problem.W.push_back(Uniform(random, -0.5, 1.5));
  }
  std::vector<std::vector<char>> taken(cells, std::vector<char>(cells, 0));
  for (int f = 0; f < faces; ++f)
  {
    const Id a = static_cast<Id>(random() % cells);
    const Id b = static_cast<Id>(random() % cells);
    if (a != b && !taken[a][b])
    {
      taken[a][b] = taken[b][a] = 1;
      problem.Faces.push_back({ a, b, std::exp(Uniform(random, -2, 2)) });
    }
  }
  problem.Parameters.Gamma = Uniform(random, 0, 2);
  problem.Parameters.Sigma = Uniform(random, 0.1, 1);
  return problem;
}

double EnergyOf(const Problem& problem, const std::vector<unsigned char>& inside)
{
  return testcut::EnergyOf(problem, problem.Parameters, inside);
}

bool MeetsDemands(const Problem& problem, const std::vector<unsigned char>& inside)
{
  for (std::size_t i = 0; i < problem.Demands.size(); ++i)
  {
    if (problem.Demands[i] != 0 && (problem.Demands[i] > 0) != (inside[i] != 0))
    {
      return false;
    }
  }
  return true;
}

/** The least energy of all labellings that meet the demands, and the fewest inside cells with it.
 */
std::pair<double, long> BruteForce(const Problem& problem)
{
  const std::size_t cells = problem.W.size();
  std::pair<double, long> best(std::numeric_limits<double>::infinity(), 0);
  std::vector<unsigned char> inside(cells);
  for (unsigned labels = 0; labels < 1u << cells; ++labels)
  {
    for (std::size_t i = 0; i < cells; ++i)
    {
      inside[i] = labels >> i & 1;
    }
    if (MeetsDemands(problem, inside))
    {
      best =
        std::min(best, { EnergyOf(problem, inside), std::count(inside.begin(), inside.end(), 1) });
    }
  }
  return best;
}

void ExpectTheBestOfAll(const Problem& problem)
{
  const Segmentation result = Solve(problem);
  const double least = BruteForce(problem).first;
  EXPECT_TRUE(MeetsDemands(problem, result.Inside));
  EXPECT_NEAR(EnergyOf(problem, result.Inside), least, 1e-12 * least);
  EXPECT_NEAR(result.Energy, least, 1e-12 * least);
}

TEST(GraphCutSegmentation, EqualsTheBestOfAllLabellings)
{
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    ExpectTheBestOfAll(RandomProblem(seed, 2 + seed % 12, 3 * (2 + seed % 12)));
  }
}

TEST(GraphCutSegmentation, EqualsTheBestOfAllLabellingsWithWeightsAndDemands)
{
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    std::mt19937 random(seed);
    Problem problem = RandomProblem(seed, 2 + seed % 11, 3 * (2 + seed % 11));
    if (seed % 3 != 0)
    {
      problem.Parameters.DataTerm = DataTerm::VolumeWeighted;
      for (std::size_t i = 0; i < problem.W.size(); ++i)
      {
        problem.Volumes.push_back(std::exp(Uniform(random, -3, 3)));
      }
    }
    for (std::size_t i = 0; seed % 3 != 1 && i < problem.W.size(); ++i)
    {
      problem.Demands.push_back(static_cast<std::int8_t>(static_cast<int>(random() % 3) - 1));
    }
    ExpectTheBestOfAll(problem);
  }
}

/** Faces that are tiny beside others have to be weighed rightly, too. */
TEST(GraphCutSegmentation, EqualsTheBestOfAllLabellingsOverManyOrdersOfSize)
{
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    std::mt19937 random(seed);
    Problem problem = RandomProblem(seed, 11, 30);
    for (InteriorFace& face : problem.Faces)
    {
      face.Area = std::pow(10, Uniform(random, -20, 0));
    }
    ExpectTheBestOfAll(problem);
  }
}

TEST(GraphCutSegmentation, MeetsDemandsHoweverMuchTheyCost)
{
  Problem problem;
  problem.W = { 1e6, 1e6, -1e6, -1e6 };
  problem.Faces = { { 0, 1, 1 }, { 1, 2, 1 }, { 2, 3, 1 } };
  problem.Parameters.Gamma = 1024;
  problem.Demands = { -1, 0, 1, 0 };
  EXPECT_EQ(Solve(problem).Inside, std::vector<unsigned char>({ 0, 1, 1, 0 }));
  EXPECT_EQ(Solve(problem).Energy, 1e6 + (1e6 + 1) + 1024 + 1024);
}

TEST(CertainCells, HaveTheirLabelInTheSmallestOfAllMinima)
{
  int certain = 0;
  int open = 0;
  for (unsigned seed = 0; seed < 100; ++seed)
  {
    // Halves and faces of weight 1: energies are exact, and many labellings tie.
    std::mt19937 random(seed);
    Problem problem = RandomProblem(seed, 10, 16);
    problem.Parameters.Gamma = seed % 3 == 0 ? 0.25 : 0.5;
    problem.Parameters.Sigma = 1e10;
    for (double& w : problem.W)
    {
      w = static_cast<double>(random() % 3) / 2;
    }
    for (InteriorFace& face : problem.Faces)
    {
      face.Area = 1;
    }
    const double least = BruteForce(problem).first;
    unsigned everywhere = ~0u; // the smallest minimum is what all of them share
    std::vector<unsigned char> inside(problem.W.size());
    for (unsigned labels = 0; labels < 1u << problem.W.size(); ++labels)
    {
      for (std::size_t i = 0; i < problem.W.size(); ++i)
      {
        inside[i] = labels >> i & 1;
      }
      everywhere &= EnergyOf(problem, inside) == least ? labels : ~0u;
    }
    const CutEnergy energy{ RealEnergy(problem, problem.Parameters) };
    const CertainCells cells(energy);
    for (Id i = 0; i < energy.NumberOfCells(); ++i)
    {
      (cells.IsOpen(i) ? open : certain) += 1;
      EXPECT_TRUE(cells.IsOpen(i) || cells.IsInside(i) == ((everywhere >> i & 1) != 0)) << seed;
    }
  }
  EXPECT_GT(certain, 300);
  EXPECT_GT(open, 100);
}

TEST(GraphCutSegmentation, OfWholeNumbersIsKnownWithoutACut)
{
  for (unsigned seed = 0; seed < 300; ++seed)
  {
    const int cells = 2 + static_cast<int>(seed % 60);
    Problem problem = RandomProblem(seed, cells, 3 * cells);
    std::mt19937 random(seed);
    for (double& w : problem.W)
    {
      w = static_cast<double>(random() % 5) - 2;
    }
    for (InteriorFace& face : problem.Faces)
    {
      face.Area = std::ldexp(face.Area, static_cast<int>(random() % 40) - 20);
    }
    SegmentMeshParameters parameters; // the defaults, or smaller weights
    parameters.Cut.Gamma *= seed % 2 ? 1 : 0.5;
    parameters.Cut.Sigma *= seed % 3 ? 1 : 0.5;
    problem.Parameters = parameters.Cut;
    Monitor monitor;
    const MeshSegmentation known = SegmentCells(problem, {}, {}, parameters, {}, monitor);
    const Segmentation cut = Solve(problem);
    EXPECT_EQ(known.Inside, cut.Inside) << seed;
    int energies = 0;
    for (const auto& [name, value] : known.Statistics)
    {
      const bool isEnergy = name.rfind("Energy", 0) == 0;
      EXPECT_EQ(value, isEnergy ? cut.Energy : 0) << seed << ' ' << name;
      energies += isEnergy;
    }
    EXPECT_EQ(energies, 3);
  }
}

TEST(GraphCutSegmentation, HasFewestInsideCellsAmongTies)
{
  int tied = 0;
  for (unsigned seed = 0; seed < 150; ++seed)
  {
    // Sigma is so large that every face weighs exactly 1: energies are sums of halves.
    Problem problem = RandomProblem(seed, 2 + seed % 11, 2 * (2 + seed % 11));
    std::mt19937 random(seed);
    for (double& w : problem.W)
    {
      w = static_cast<double>(random() % 3) / 2;
    }
    for (InteriorFace& face : problem.Faces)
    {
      face.Area = 4;
    }
    problem.Parameters.Gamma = seed % 2 ? 1 : 0.5;
    problem.Parameters.Sigma = 1e10;
    const Segmentation result = Solve(problem);
    const std::pair<double, long> best = BruteForce(problem);
    EXPECT_EQ(result.Energy, best.first);
    EXPECT_EQ(std::count(result.Inside.begin(), result.Inside.end(), 1), best.second);
    Problem opposite = problem; // of which the solution has the most outside cells
    for (double& w : opposite.W)
    {
      w = 1 - w;
    }
    const Segmentation other = Solve(opposite);
    EXPECT_EQ(other.Energy, result.Energy);
    tied += static_cast<std::size_t>(best.second +
              std::count(other.Inside.begin(), other.Inside.end(), 1)) != problem.W.size();
  }
  EXPECT_GT(tied, 50);
}

void ExpectTheThreshold(Problem problem)
{
  problem.Parameters.Gamma = 0;
  problem.W[0] = 0.5;
  problem.W[1] = std::nextafter(0.5, 1);
  problem.W[2] = std::nextafter(0.5, 0);
  problem.W[3] = 1e300;
  problem.W[4] = -1e300;
  problem.W[5] = std::numeric_limits<double>::denorm_min();
  problem.W[6] = -0.0;
  problem.W[7] = std::numeric_limits<double>::max();
  const Segmentation result = Solve(problem);
  for (std::size_t i = 0; i < problem.W.size(); ++i)
  {
    EXPECT_EQ(result.Inside[i], problem.W[i] > 0.5) << problem.W[i];
  }
}

TEST(GraphCutSegmentation, ThresholdsExactlyWithoutSmoothness)
{
  ExpectTheThreshold(RandomProblem(1, 1000, 5000));
  Problem weighted = RandomProblem(2, 1000, 5000);
  weighted.Parameters.DataTerm = DataTerm::VolumeWeighted;
  weighted.Volumes.assign(1000, 1e-300);
  weighted.Volumes[1] = 0;
  weighted.Volumes[10] = 1e300;
  ExpectTheThreshold(weighted);
}

TEST(GraphCutSegmentation, KeepsAPreferenceHoweverSmallNextToHugeWeights)
{
  Problem problem;
  problem.W = { std::nextafter(0.5, 1), 0.3, 0.3, 0.5 };
  problem.Faces = { { 1, 2, 1e300 } };
  problem.Parameters.Gamma = 1e300;
  EXPECT_EQ(Solve(problem).Inside, std::vector<unsigned char>({ 1, 0, 0, 0 }));
}

/** @return whether thresholding would have been as good */
bool ExpectWhatBoostFinds(const Problem& problem)
{
  const double least = testcut::LeastEnergy(problem, problem.Parameters);
  const Segmentation result = Solve(problem);
  EXPECT_NEAR(result.Energy, least, 1e-11 * least);
  EXPECT_NEAR(EnergyOf(problem, result.Inside), least, 1e-11 * least);
  std::vector<unsigned char> threshold;
  for (const double w : problem.W)
  {
    threshold.push_back(w > 0.5);
  }
  return EnergyOf(problem, threshold) < 1.0001 * least;
}

TEST(GraphCutSegmentation, AgreesWithBoost)
{
  for (unsigned seed = 0; seed < 6; ++seed)
  {
    Problem problem = RandomProblem(seed, 3000, 6000);
    problem.Parameters.Gamma = 0.3 + 0.2 * seed;
    EXPECT_FALSE(ExpectWhatBoostFinds(problem));
  }
}

/** The hull of a random surface; with few triangles w is unsure nearly everywhere. */
Problem HullProblem(const TriangleSoup& soup)
{
  Monitor monitor;
  const HullMesh hull = MeshHull(soup, {}, monitor);
  Problem problem;
  problem.W = hull.W;
  problem.Faces = InteriorFaces(hull.Mesh);
  problem.Volumes = CellVolumes(hull.Mesh);
  return problem;
}

/** A ball of small triangles without every fifth. */
TriangleSoup TornBall(int rings)
{
  TriangleSoup ball;
  const int sides = 2 * rings;
  const double pi = 3.14159265358979323846;
  for (int i = 0; i <= rings; ++i)
  {
    for (int j = 0; j < sides; ++j)
    {
      const double polar = pi * i / rings;
      const double azimuth = 2 * pi * j / sides;
      ball.Points.push_back({ std::sin(polar) * std::cos(azimuth),
        std::sin(polar) * std::sin(azimuth), std::cos(polar) });
    }
  }
  for (int i = 0; i < rings; ++i)
  {
    for (int j = 0; j < sides; ++j)
    {
      const Id a = i * sides + j;
      const Id b = i * sides + (j + 1) % sides;
      if ((7 * i + 3 * j) % 5 != 0)
      {
        ball.Triangles.push_back({ a, a + sides, b });
        ball.Triangles.push_back({ b, a + sides, b + sides });
      }
    }
  }
  return ball;
}

TEST(GraphCutSegmentation, AgreesWithBoostOnHulls)
{
  int unlikeThresholds = 0;
  for (const TriangleSoup& soup : { TornBall(20), testmeshes::RandomSoup(1, 60),
         testmeshes::GridSoup(2, 40, 5), testmeshes::GridSoup(3, 60, 4) })
  {
    Problem problem = HullProblem(soup);
    for (const DataTerm term : { DataTerm::Uniform, DataTerm::VolumeWeighted })
    {
      problem.Parameters.DataTerm = term;
      unlikeThresholds += !ExpectWhatBoostFinds(problem);
    }
  }
  EXPECT_GE(unlikeThresholds, 4);
}

TEST(GraphCutSegmentation, DoesNotDependOnTheSizeOfTheSurface)
{
  const TriangleSoup soup = TornBall(12);
  const Problem problem = HullProblem(soup);
  for (const double factor : { 0x1p20, 0x1p-20 })
  {
    TriangleSoup scaled = soup;
    for (Point& p : scaled.Points)
    {
      p = { factor * p[0], factor * p[1], factor * p[2] };
    }
    Problem other = HullProblem(scaled);
    EXPECT_EQ(other.W, problem.W);
    for (const DataTerm term : { DataTerm::Uniform, DataTerm::VolumeWeighted })
    {
      Problem asGiven = problem;
      asGiven.Parameters.DataTerm = other.Parameters.DataTerm = term;
      EXPECT_EQ(Solve(other).Inside, Solve(asGiven).Inside);
      EXPECT_EQ(Solve(other).Energy, Solve(asGiven).Energy);
    }
  }
}

TEST(GraphCutSegmentation, IsTheSameForAnyNumberOfThreads)
{
  const Problem problem = HullProblem(TornBall(16));
  const WholeTeams teams;
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const Segmentation alone = Solve(problem);
  for (const int threads : { 2, 3, 8 })
  {
    omp_set_num_threads(threads);
    const Segmentation together = Solve(problem);
    EXPECT_EQ(together.Inside, alone.Inside);
    EXPECT_EQ(together.Energy, alone.Energy);
  }
  omp_set_num_threads(before);
}

TEST(CutEnergy, NeighborsAreInTheOrderOfFacesOnAnyNumberOfThreads)
{
  const Problem problem = HullProblem(TornBall(16));
  const WholeTeams teams;
  const int before = omp_get_max_threads();
  for (const int threads : { 1, 2, 8 })
  {
    omp_set_num_threads(threads);
    const CutEnergy energy{ RealEnergy(problem, problem.Parameters) };
    std::size_t count = 0;
    for (Id cell = 0; cell < energy.NumberOfCells(); ++cell)
    {
      const auto neighbors = energy.Neighbors(cell);
      count += neighbors.Size();
      EXPECT_TRUE(std::is_sorted(neighbors.begin(), neighbors.end(),
        [](const CutEnergy::Neighbor& a, const CutEnergy::Neighbor& b)
        { return a.Face < b.Face; }));
      for (const CutEnergy::Neighbor& neighbor : neighbors)
      {
        const auto& [first, second, area] = problem.Faces[neighbor.Face];
        EXPECT_EQ(first == cell ? second : first, neighbor.Cell);
      }
    }
    EXPECT_GT(count, problem.Faces.size());
  }
  omp_set_num_threads(before);
}

TEST(GraphCutSegmentation, ReturnsTheSolidOfAClosedSurfaceWithDefaults)
{
  for (unsigned seed = 0; seed < 5; ++seed)
  {
    std::mt19937 random(seed);
    Problem problem = RandomProblem(seed, 2000, 8000);
    problem.Parameters = GraphCutParameters();
    for (double& w : problem.W)
    {
      w = static_cast<double>(random() % 2);
    }
    for (InteriorFace& face : problem.Faces)
    {
      face.Area = std::pow(10, Uniform(random, -3, 3));
    }
    const Segmentation result = Solve(problem);
    for (std::size_t i = 0; i < problem.W.size(); ++i)
    {
      EXPECT_EQ(result.Inside[i], problem.W[i] == 1);
    }
    // Each face between them costs gamma exp(-1 / (2 sigma^2)) times its relative area.
    const double sigma = problem.Parameters.Sigma;
    const double areas = static_cast<double>(problem.Faces.size());
    EXPECT_LT(result.Energy, problem.Parameters.Gamma * std::exp(-0.5 / (sigma * sigma)) * areas);
  }
}

TEST(GraphCutSegmentation, DoesNotDependOnTheScaleOfAreas)
{
  const Problem problem = RandomProblem(3, 500, 2000);
  const Segmentation result = Solve(problem);
  for (double factor : { 0x1p20, 0x1p-20, 0x1p1000, 0x1p-1000 })
  {
    Problem scaled = problem;
    for (InteriorFace& face : scaled.Faces)
    {
      face.Area *= factor;
    }
    const Segmentation other = Solve(scaled);
    EXPECT_EQ(other.Inside, result.Inside);
    EXPECT_EQ(other.Energy, result.Energy);
  }
}

TEST(GraphCutSegmentation, IsNotPutOffByHugeWindingNumbers)
{
  for (unsigned seed = 0; seed < 30; ++seed)
  {
    const Problem alone = RandomProblem(seed, 12, 40);
    Problem problem = alone;
    problem.W.push_back(1e200);
    problem.W.push_back(-1e200);
    double areas = 0;
    for (const InteriorFace& face : alone.Faces)
    {
      areas += face.Area;
    }
    // Faces of average area leave the mean as it is; across such steps they weigh nothing.
    const double mean = areas / static_cast<double>(alone.Faces.size());
    problem.Faces.push_back({ 0, 12, mean });
    problem.Faces.push_back({ 1, 13, mean });
    problem.Faces.push_back({ 13, 2, mean });
    std::vector<unsigned char> inside = Solve(problem).Inside;
    EXPECT_EQ(inside[12], 1);
    EXPECT_EQ(inside[13], 0);
    inside.resize(12);
    const double least = BruteForce(alone).first;
    EXPECT_NEAR(EnergyOf(alone, inside), least, 1e-12 * least) << seed;
  }
}

TEST(GraphCutSegmentation, WorksWithoutFacesWithoutCellsAndWithoutAreas)
{
  Problem problem;
  EXPECT_TRUE(Solve(problem).Inside.empty());
  EXPECT_EQ(Solve(problem).Energy, 0);
  problem.W = { 0.75, 0.25, 2, -1 };
  EXPECT_EQ(Solve(problem).Inside, std::vector<unsigned char>({ 1, 0, 1, 0 }));
  EXPECT_EQ(Solve(problem).Energy, 0.5);
  problem.Faces = { { 0, 1, 0 }, { 1, 2, 0 } };
  EXPECT_EQ(Solve(problem).Inside, std::vector<unsigned char>({ 1, 0, 1, 0 }));
  EXPECT_EQ(Solve(problem).Energy, 0.5);
  problem.Parameters.Sigma = 1e-300; // its square is 0
  problem.Faces[0].Area = 1;
  problem.W[1] = 0.75;
  EXPECT_EQ(Solve(problem).Inside, std::vector<unsigned char>({ 1, 1, 1, 0 }));
  EXPECT_EQ(Solve(problem).Energy, 0.5);
}

TEST(GraphCutSegmentation, NamesWhatIsInvalid)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const auto message = [](auto change)
  {
    Problem problem;
    problem.W = { 0, 1, 0.5 };
    problem.Faces = { { 0, 1, 1 }, { 1, 2, 1 } };
    Solve(problem);
    change(problem);
    try
    {
      Solve(problem);
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.Code, ErrorCode::InvalidParameter);
      return std::string(error.what());
    }
    return std::string("nothing was thrown");
  };
  const auto names = [&](const std::string& culprit, auto change)
  {
    const std::string text = message(change);
    EXPECT_NE(text.find(culprit), std::string::npos) << text << " should name " << culprit;
  };
  for (double bad : { -1.0, -1e-300, nan, infinity, -infinity })
  {
    names("gamma", [&](Problem& p) { p.Parameters.Gamma = bad; });
    names("face 1", [&](Problem& p) { p.Faces[1].Area = bad; });
  }
  for (double bad : { 0.0, -0.0, -1.0, nan, infinity })
  {
    names("sigma", [&](Problem& p) { p.Parameters.Sigma = bad; });
  }
  for (double bad : { nan, infinity, -infinity })
  {
    names("cell 2", [&](Problem& p) { p.W[2] = bad; });
  }
  for (Id bad : { -1, 3, std::numeric_limits<Id>::max(), std::numeric_limits<Id>::min() })
  {
    names(
      "face 0 refers to cell " + std::to_string(bad), [&](Problem& p) { p.Faces[0].First = bad; });
    names(
      "face 1 refers to cell " + std::to_string(bad), [&](Problem& p) { p.Faces[1].Second = bad; });
  }
  names("face 1", [&](Problem& p) { p.Faces[1].Second = 1; });
  names("2 demands for 3", [&](Problem& p) { p.Demands = { 0, 1 }; });
  names("0 volumes for 3", [&](Problem& p) { p.Parameters.DataTerm = DataTerm::VolumeWeighted; });
  for (double bad : { -1.0, nan, infinity })
  {
    names("cell 1 has a volume",
      [&](Problem& p)
      {
        p.Parameters.DataTerm = DataTerm::VolumeWeighted;
        p.Volumes = { 1, bad, 1 };
      });
  }
}

TEST(GraphCutSegmentation, StopsAtEveryCheck)
{
  class Stopping : public Monitor
  {
  public:
    bool Continue(const char* stage, double fraction) override
    {
      EXPECT_STREQ(stage, "segmenting");
      this->Last = fraction;
      return this->Allowed-- > 0;
    }
    int Allowed = 1000;
    double Last = 0;
  };
  const Problem problem = RandomProblem(1, 20, 40);
  Stopping all;
  GraphCutSegmentation(problem, problem.Parameters, all);
  EXPECT_EQ(all.Last, 1);
  const int checks = 1000 - all.Allowed;
  EXPECT_GE(checks, 2);
  for (int allowed = 0; allowed < checks; ++allowed)
  {
    Stopping monitor;
    monitor.Allowed = allowed;
    try
    {
      GraphCutSegmentation(problem, problem.Parameters, monitor);
      ADD_FAILURE() << "did not stop at check " << allowed;
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.Code, ErrorCode::Stopped);
    }
  }
}
} // namespace
