// SPDX-License-Identifier: GPL-3.0-or-later
#include "GraphCutSegmentation.h"

// In optimized builds gcc 12 suspects uninitialized values all over Boost's algorithm.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

namespace
{
using namespace insideout;

struct Problem
{
  std::vector<double> W;
  std::vector<InteriorFace> Faces;
  GraphCutParameters Parameters;
};

Segmentation Solve(const Problem& problem)
{
  Monitor monitor;
  return GraphCutSegmentation(problem.W, problem.Faces, problem.Parameters, monitor);
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

/** v_ij, as in the header. */
std::vector<double> Smoothness(const Problem& problem)
{
  double sum = 0;
  for (const InteriorFace& face : problem.Faces)
  {
    sum += face.Area;
  }
  std::vector<double> terms;
  for (const InteriorFace& face : problem.Faces)
  {
    const double step = problem.W[face.First] - problem.W[face.Second];
    const double sigma = problem.Parameters.Sigma;
    terms.push_back(face.Area / (sum / static_cast<double>(problem.Faces.size())) *
      std::exp(-step * step / (2 * sigma * sigma)));
  }
  return terms;
}

double Energy(const Problem& problem, const std::vector<double>& smoothness,
  const std::vector<unsigned char>& inside)
{
  double energy = 0;
  for (std::size_t i = 0; i < problem.W.size(); ++i)
  {
    energy += inside[i] ? std::max(1 - problem.W[i], 0.0) : std::max(problem.W[i], 0.0);
  }
  for (std::size_t f = 0; f < problem.Faces.size(); ++f)
  {
    if (inside[problem.Faces[f].First] != inside[problem.Faces[f].Second])
    {
      energy += problem.Parameters.Gamma * smoothness[f];
    }
  }
  return energy;
}

/** The least energy, and the fewest inside cells among the labellings that have it. */
std::pair<double, long> BruteForce(const Problem& problem)
{
  const std::vector<double> smoothness = Smoothness(problem);
  const std::size_t cells = problem.W.size();
  std::pair<double, long> best(std::numeric_limits<double>::infinity(), 0);
  std::vector<unsigned char> inside(cells);
  for (unsigned labels = 0; labels < 1u << cells; ++labels)
  {
    for (std::size_t i = 0; i < cells; ++i)
    {
      inside[i] = labels >> i & 1;
    }
    best = std::min(
      best, { Energy(problem, smoothness, inside), std::count(inside.begin(), inside.end(), 1) });
  }
  return best;
}

TEST(GraphCutSegmentation, EqualsTheBestOfAllLabellings)
{
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    const Problem problem = RandomProblem(seed, 2 + seed % 13, 3 * (2 + seed % 13));
    const Segmentation result = Solve(problem);
    const double least = BruteForce(problem).first;
    EXPECT_NEAR(Energy(problem, Smoothness(problem), result.Inside), least, 1e-12 * least);
    EXPECT_NEAR(result.Energy, least, 1e-12 * least);
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

TEST(GraphCutSegmentation, ThresholdsExactlyWithoutSmoothness)
{
  Problem problem = RandomProblem(1, 1000, 5000);
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

TEST(GraphCutSegmentation, KeepsAPreferenceHoweverSmallNextToHugeWeights)
{
  Problem problem;
  problem.W = { std::nextafter(0.5, 1), 0.3, 0.3, 0.5 };
  problem.Faces = { { 1, 2, 1e300 } };
  problem.Parameters.Gamma = 1e300;
  EXPECT_EQ(Solve(problem).Inside, std::vector<unsigned char>({ 1, 0, 0, 0 }));
}

TEST(GraphCutSegmentation, AgreesWithBoost)
{
  using Capacity = std::int64_t;
  using Traits = boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::directedS>;
  using Edge = Traits::edge_descriptor;
  using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS,
    boost::property<boost::vertex_index_t, long,
      boost::property<boost::vertex_color_t, boost::default_color_type,
        boost::property<boost::vertex_distance_t, long,
          boost::property<boost::vertex_predecessor_t, Edge>>>>,
    boost::property<boost::edge_capacity_t, Capacity,
      boost::property<boost::edge_residual_capacity_t, Capacity,
        boost::property<boost::edge_reverse_t, Edge>>>>;
  const double unit = 0x1p-50; // the flow fits in 63 bits
  for (unsigned seed = 0; seed < 6; ++seed)
  {
    const int cells = 3000;
    Problem problem = RandomProblem(seed, cells, 2 * cells);
    problem.Parameters.Gamma = 0.3 + 0.2 * seed;
    const std::vector<double> smoothness = Smoothness(problem);
    Graph graph(cells + 2);
    const auto add = [&](int a, int b, double forth, double back)
    {
      const Edge ab = boost::add_edge(a, b, graph).first;
      const Edge ba = boost::add_edge(b, a, graph).first;
      boost::put(boost::edge_capacity, graph, ab, std::llround(forth / unit));
      boost::put(boost::edge_capacity, graph, ba, std::llround(back / unit));
      boost::put(boost::edge_reverse, graph, ab, ba);
      boost::put(boost::edge_reverse, graph, ba, ab);
    };
    for (int i = 0; i < cells; ++i)
    {
      add(cells, i, std::max(problem.W[i], 0.0), 0);
      add(i, cells + 1, std::max(1 - problem.W[i], 0.0), 0);
    }
    for (std::size_t f = 0; f < problem.Faces.size(); ++f)
    {
      const double capacity = problem.Parameters.Gamma * smoothness[f];
      add(problem.Faces[f].First, problem.Faces[f].Second, capacity, capacity);
    }
    const double flow =
      unit * static_cast<double>(boost::boykov_kolmogorov_max_flow(graph, cells, cells + 1));
    const Segmentation result = Solve(problem);
    EXPECT_NEAR(result.Energy, flow, 1e-12 * flow);
    EXPECT_NEAR(Energy(problem, smoothness, result.Inside), flow, 1e-12 * flow);
    // Not the threshold, or the smoothness would do nothing here.
    std::vector<unsigned char> threshold;
    for (double w : problem.W)
    {
      threshold.push_back(w > 0.5);
    }
    EXPECT_GT(Energy(problem, smoothness, threshold), 1.0001 * flow);
  }
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
    EXPECT_LT(result.Energy, 1e-15);
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
    EXPECT_NEAR(Energy(alone, Smoothness(alone), inside), least, 1e-12 * least) << seed;
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
  GraphCutSegmentation(problem.W, problem.Faces, problem.Parameters, all);
  EXPECT_EQ(all.Last, 1);
  const int checks = 1000 - all.Allowed;
  EXPECT_GE(checks, 2);
  for (int allowed = 0; allowed < checks; ++allowed)
  {
    Stopping monitor;
    monitor.Allowed = allowed;
    try
    {
      GraphCutSegmentation(problem.W, problem.Faces, problem.Parameters, monitor);
      ADD_FAILURE() << "did not stop at check " << allowed;
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.Code, ErrorCode::Stopped);
    }
  }
}
} // namespace
