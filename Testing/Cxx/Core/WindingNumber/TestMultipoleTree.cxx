// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/MultipoleTree.h"

#include "Common/Vectors.h"
#include "WindingNumber/Pi.h"
#include "WindingNumber/SolidAngle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{
using namespace insideout;

constexpr std::size_t ManySites = 1000000;

/** Groups of triangles, each in a small ball, along a diagonal. */
struct Groups
{
  std::vector<Point> Points;
  std::vector<std::vector<CountedTriangle>> Triangles;

  explicit Groups(unsigned seed)
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> part(-0.5, 0.5);
    const int groups = 48;
    for (int g = 0; g < groups; ++g)
    {
      this->Triangles.emplace_back();
      const double middle = (g + 0.5) / groups - 0.5;
      for (int t = 0; t < 10; ++t)
      {
        const Id first = static_cast<Id>(this->Points.size());
        for (int k = 0; k < 3; ++k)
        {
          const double size = 0.02;
          this->Points.push_back({ middle + size * part(random), middle + size * part(random),
            middle + size * part(random) });
        }
        this->Triangles.back().push_back({ { first, first + 1, first + 2 }, t % 2 == 0 ? 1 : -2 });
      }
    }
  }

  double WindingNumberAt(const Point& p, const std::vector<Id>& groups) const
  {
    double sum = 0;
    for (const Id group : groups)
    {
      for (const CountedTriangle& triangle : this->Triangles[group])
      {
        const std::array<Point, 3> corners = CornersOf(this->Points, triangle.Corners);
        sum += triangle.Count * std::arg(HalfSolidAngle(corners, SiteAt(p))) / (2 * Pi);
      }
    }
    return sum;
  }
};

MultipoleTree TreeOf(const Groups& groups, std::size_t sites = ManySites)
{
  Monitor silent;
  return { groups.Points, groups.Triangles, sites, silent, { "", 0, 1 } };
}

/** Sites about as near to each other as `size`. */
SiteBlock BlockAt(const Point& middle, double size, std::mt19937& random)
{
  std::uniform_real_distribution<double> part(-0.5, 0.5);
  SiteBlock block = {};
  for (int axis = 0; axis < 3; ++axis)
  {
    for (double& x : block.High[axis])
    {
      x = middle[axis] + size * part(random);
    }
  }
  return block;
}

TEST(MultipoleTree, FarAndNearGroupsAddUpToAll)
{
  const Groups groups(1);
  const MultipoleTree tree = TreeOf(groups);
  std::vector<Id> all(groups.Triangles.size());
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    all[i] = static_cast<Id>(i);
  }
  std::mt19937 random(2);
  std::uniform_real_distribution<double> part(-0.5, 0.5);
  for (int trial = 0; trial < 100; ++trial)
  {
    const double extent = std::exp2(trial % 10 - 2);
    const Point middle = { extent * part(random), extent * part(random), extent * part(random) };
    const SiteBlock block = BlockAt(middle, 0.01, random);
    MultipoleTree::Selection selection;
    tree.Select(BallAround(block), selection);
    EXPECT_LT(selection.Far.size() + selection.Near.size(), all.size());
    double w[Lanes] = {};
    tree.Add(selection, block, w);
    for (int lane = 0; lane < Lanes; ++lane)
    {
      const Point site = { block.High[0][lane], block.High[1][lane], block.High[2][lane] };
      const double near = groups.WindingNumberAt(site, selection.Near);
      EXPECT_NEAR(w[lane] + near, groups.WindingNumberAt(site, all), 4e-15);
    }
  }
}

TEST(MultipoleTree, FewSitesFindAllGroupsNear)
{
  const Groups groups(1);
  const MultipoleTree tree = TreeOf(groups, 100);
  std::mt19937 random(2);
  MultipoleTree::Selection selection;
  tree.Select(BallAround(BlockAt({ 100, 0, 0 }, 0.01, random)), selection);
  EXPECT_TRUE(selection.Far.empty());
  EXPECT_EQ(selection.Near.size(), groups.Triangles.size());
}

TEST(MultipoleTree, CanBeStopped)
{
  struct Stop : Monitor
  {
    bool Continue(const char*, double) override { return false; }
  } stop;
  const Groups groups(1);
  EXPECT_THROW(
    MultipoleTree(groups.Points, groups.Triangles, ManySites, stop, { "", 0, 1 }), Error);
}

TEST(MultipoleTree, GroupsWhoseSizeUnderflowsWhenSquaredAddNothingVisible)
{
  Groups groups(1);
  for (Point& p : groups.Points)
  {
    for (double& x : p)
    {
      x = std::ldexp(x, -600);
    }
  }
  const MultipoleTree tree = TreeOf(groups);
  std::mt19937 random(2);
  const SiteBlock block = BlockAt({ 0.5, 0, 0 }, 0.01, random);
  MultipoleTree::Selection selection;
  tree.Select(BallAround(block), selection);
  EXPECT_FALSE(selection.Far.empty());
  double w[Lanes] = {};
  tree.Add(selection, block, w);
  for (const double value : w)
  {
    EXPECT_LT(std::abs(value), 1e-100); // false for NaN
  }
}

TEST(MultipoleTree, DegreesFallWithDistance)
{
  const Groups groups(1);
  const MultipoleTree tree = TreeOf(groups);
  std::mt19937 random(2);
  int last = MultipoleDegree + 1;
  for (const double distance : { 8., 64., 512., 4096. })
  {
    MultipoleTree::Selection selection;
    tree.Select(BallAround(BlockAt({ distance, 0, 0 }, 0.01, random)), selection);
    ASSERT_EQ(selection.Far.size(), 1U);
    EXPECT_LT(selection.Far[0].Degree, last);
    last = selection.Far[0].Degree;
  }
}

TEST(Multipole, ChargesInsideTheBallGiveTheirPotential)
{
  const Point charge = { 0.1, -0.1, 0.05 };
  const auto potential = [&](const Point& p) { return 1 / Length(Difference(p, charge)); };
  std::vector<double> values;
  for (const Point& p : MultipoleSamples())
  {
    values.push_back(potential(p));
  }
  const Multipole multipole = MultipoleOf(values);
  const std::array<double, MultipoleDegree + 1> bounds = MultipoleBounds(multipole);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(-3, 3);
  for (int trial = 0; trial < 100; ++trial)
  {
    double at[3][Lanes];
    double w[Lanes] = {};
    double less[Lanes] = {};
    std::array<Point, Lanes> sites;
    for (int lane = 0; lane < Lanes; ++lane)
    {
      do
      {
        sites[lane] = { part(random), part(random), part(random) };
      } while (Length(sites[lane]) < 1);
      for (int axis = 0; axis < 3; ++axis)
      {
        at[axis][lane] = sites[lane][axis];
      }
    }
    AddMultipole(multipole, MultipoleDegree, at, w);
    AddMultipole(multipole, 3, at, less);
    for (int lane = 0; lane < Lanes; ++lane)
    {
      EXPECT_NEAR(w[lane], potential(sites[lane]), 4e-15);
      const double t = 1 / Length(sites[lane]);
      double rest = 1e-15;
      for (int l = 4; l <= MultipoleDegree; ++l)
      {
        rest += bounds[l] * std::pow(t, l + 1);
      }
      EXPECT_LE(std::abs(w[lane] - less[lane]), rest);
    }
  }
}
} // namespace
