// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/MultipoleTree.h"

#include "Common/Vectors.h"
#include "WindingNumber/Pi.h"
#include "WindingNumber/SolidAngle.h"
#include "WindingNumber/TranslateMultipoles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
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
    tree.Select(BallAround(block), tree.Roots(), selection);
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

TEST(MultipoleTree, NestedLocalFieldsAndTheRestAddUpToAll)
{
  const Groups groups(1);
  const MultipoleTree tree = TreeOf(groups);
  std::vector<Id> all(groups.Triangles.size());
  std::iota(all.begin(), all.end(), 0);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> part(-0.5, 0.5);
  int fields = 0;
  for (int trial = 0; trial < 100; ++trial)
  {
    const double extent = std::exp2(trial % 10 - 2);
    const double size = std::exp2(-trial % 7);
    const Point middle = { extent * part(random), extent * part(random), extent * part(random) };
    // The outer ball has a corner where the sites are; the inner one is the sites' own.
    const SiteBlock block = BlockAt(middle, size / 4, random);
    const Point corner = { middle[0] + size / 2, middle[1] - size / 3, middle[2] + size / 4 };
    const double reach = QuickDistance(middle, corner) + size / 4;
    const MultipoleTree::Local outer = tree.Around({ corner, reach }, tree.Roots());
    const MultipoleTree::Local inner = tree.Around(BallAround(block), outer.Rest);
    fields += (outer.Degree >= 0) + (inner.Degree >= 0);
    MultipoleTree::Selection selection;
    tree.Select(BallAround(block), inner.Rest, selection);
    double w[Lanes] = {};
    tree.Add(outer, block, w);
    tree.Add(inner, block, w);
    tree.Add(selection, block, w);
    for (int lane = 0; lane < Lanes; ++lane)
    {
      const Point site = { block.High[0][lane], block.High[1][lane], block.High[2][lane] };
      const double near = groups.WindingNumberAt(site, selection.Near);
      EXPECT_NEAR(w[lane] + near, groups.WindingNumberAt(site, all), 4e-15) << trial;
    }
  }
  EXPECT_GT(fields, 100);
}

TEST(MultipoleTree, SitesAtOnePlaceHaveNoLocalField)
{
  const Groups groups(1);
  const MultipoleTree tree = TreeOf(groups);
  EXPECT_EQ(tree.Around({ { 8, 0, 0 }, 0 }, tree.Roots()).Degree, -1);
  EXPECT_EQ(tree.Around({ { 8, 0, 0 }, 0 }, tree.Roots()).Rest, tree.Roots());
  EXPECT_EQ(tree.Around({ { 8, 0, 0 }, 1e-300 }, tree.Roots()).Degree, 0);
}

TEST(MultipoleTree, FewSitesFindAllGroupsNear)
{
  const Groups groups(1);
  const MultipoleTree tree = TreeOf(groups, 100);
  std::mt19937 random(2);
  MultipoleTree::Selection selection;
  tree.Select(BallAround(BlockAt({ 100, 0, 0 }, 0.01, random)), tree.Roots(), selection);
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
  tree.Select(BallAround(block), tree.Roots(), selection);
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
    tree.Select(BallAround(BlockAt({ distance, 0, 0 }, 0.01, random)), tree.Roots(), selection);
    ASSERT_EQ(selection.Far.size(), 1U);
    EXPECT_LT(selection.Far[0].Degree, last);
    last = selection.Far[0].Degree;
  }
}

double PotentialOf(const Point& charge, const Point& p)
{
  return 1 / Length(Difference(p, charge));
}

Multipole MultipoleOfCharge(const Point& charge)
{
  std::vector<double> values;
  for (const Point& p : MultipoleSamples())
  {
    values.push_back(PotentialOf(charge, p));
  }
  return MultipoleOf(values);
}

TEST(Multipole, ChargesInsideTheBallGiveTheirPotential)
{
  const Point charge = { 0.1, -0.1, 0.05 };
  const auto potential = [&](const Point& p) { return PotentialOf(charge, p); };
  const Multipole multipole = MultipoleOfCharge(charge);
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

TEST(TranslateMultipoles, ChargesOutsideTheBallGiveTheirPotential)
{
  // Charges at a distance in all directions, along each axis too.
  const double radius = 0.3;
  std::vector<Point> centers = { { 0, 0, 5 }, { 0, 0, -6 }, { 7, 0, 0 }, { 0, -5, 0 } };
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(-0.5, 0.5);
  while (centers.size() < Lanes - 1)
  {
    const Point p = { 20 * part(random), 20 * part(random), 20 * part(random) };
    if (Length(p) > 5)
    {
      centers.push_back(p);
    }
  }
  FarMultipoles far = {};
  std::vector<Multipole> fields;
  std::vector<Point> charges;
  for (const Point& center : centers)
  {
    charges.push_back({ 0.2 * part(random), 0.2 * part(random), 0.2 * part(random) });
    fields.push_back(MultipoleOfCharge(charges.back()));
    for (int axis = 0; axis < 3; ++axis)
    {
      charges.back()[axis] += center[axis];
    }
  }
  for (int lane = 0; lane < Lanes; ++lane)
  {
    const std::size_t k = static_cast<std::size_t>(std::min(lane, Lanes - 2));
    const double distance = Length(centers[k]);
    far.Fields[lane] = &fields[k];
    for (int axis = 0; axis < 3; ++axis)
    {
      far.Direction[axis][lane] = -centers[k][axis] / distance;
    }
    far.Unit[lane] = lane < Lanes - 1 ? 1 / distance : 0; // the last one is left out
    far.Radius[lane] = radius / distance;
  }
  for (const int degree : { 0, 3, 8, MultipoleDegree })
  {
    Multipole local = {};
    TranslateMultipoles(far, MultipoleDegree, degree, local);
    double at[3][Lanes];
    double w[Lanes] = {};
    double expected[Lanes] = {};
    for (int lane = 0; lane < Lanes; ++lane)
    {
      Point site;
      for (int axis = 0; axis < 3; ++axis)
      {
        at[axis][lane] = lane == 0 ? 0 : part(random);
        site[axis] = radius * at[axis][lane];
      }
      for (const Point& charge : charges)
      {
        expected[lane] += PotentialOf(charge, site);
      }
    }
    AddLocal(local, degree, at, w);
    const double t = radius / 4.8;
    for (int lane = 0; lane < Lanes; ++lane)
    {
      const double rest = Lanes / 4.8 * std::pow(t, degree + 1) / (1 - t);
      EXPECT_NEAR(w[lane], expected[lane], rest + 2e-15) << degree;
    }
    EXPECT_NEAR(w[0], expected[0], 2e-15) << degree; // at the center
  }
}
} // namespace
