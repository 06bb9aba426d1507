// SPDX-License-Identifier: GPL-3.0-or-later
#include "Resolve/FacetsNearOthers.h"

#include "Common/Box.h"
#include "Support/TestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace
{
using namespace insideout;

/** Triangles of all sizes, some of them long or flat. */
TriangleSoup AllSizes(std::mt19937& random, int count)
{
  std::uniform_real_distribution<double> place(0, 1);
  TriangleSoup soup;
  for (int i = 0; i < count; ++i)
  {
    const double size = std::pow(10, -3 * place(random));
    const Point middle = { place(random), place(random), place(random) };
    for (int k = 0; k < 3; ++k)
    {
      soup.Points.push_back({ middle[0] + size * (place(random) - 0.5), middle[1], middle[2] });
      soup.Points.back()[i % 3] += size * (place(random) - 0.5);
    }
    const Id first = 3 * i;
    soup.Triangles.push_back({ first, first + 1, first + 2 });
  }
  return soup;
}

TEST(FacetsNearOthers, HoldAllThatBruteForceFinds)
{
  std::mt19937 random(3);
  for (const double scale : { 1.0, 1e-300, 1e300, std::numeric_limits<double>::max() / 2 })
  {
    for (int trial = 0; trial < 40; ++trial)
    {
      TriangleSoup soup = AllSizes(random, 1 + trial * 5);
      std::vector<Id> bodies;
      for (std::size_t f = 0; f < soup.Triangles.size(); ++f)
      {
        bodies.push_back(std::uniform_int_distribution<Id>(-1, 3)(random));
      }
      for (Point& p : soup.Points)
      {
        p = { p[0] * scale, (trial % 4 == 0 ? 0.5 : p[1]) * scale, p[2] * scale };
      }
      const double radius = trial % 2 == 0 ? 0 : 0.01 * scale;
      const std::vector<Id> near = FacetsNearOthers(soup.Points, soup.Triangles, bodies, radius);
      EXPECT_TRUE(std::is_sorted(near.begin(), near.end()));
      const auto box = [&](std::size_t f)
      { return BoundingBox(soup.Points, soup.Triangles[f]).Widened(radius); };
      for (std::size_t f = 0; f < bodies.size(); ++f)
      {
        const bool isFound = std::binary_search(near.begin(), near.end(), static_cast<Id>(f));
        EXPECT_FALSE(isFound && bodies[f] == None);
        for (std::size_t g = 0; g < bodies.size() && !isFound; ++g)
        {
          EXPECT_FALSE(bodies[f] != None && bodies[g] != None && bodies[f] != bodies[g] &&
            box(f).Meets(box(g)));
        }
      }
    }
  }
}

TEST(FacetsNearOthers, AreFewWhereBodiesMeetInFewPlaces)
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> place(0, 1);
  TriangleSoup both;
  std::vector<Id> bodies;
  for (Id f = 0; f < 2000; ++f)
  {
    const Point p = { place(random) + f % 2 * 0.9, place(random), place(random) };
    for (int k = 0; k < 3; ++k)
    {
      both.Points.push_back(p);
      both.Points.back()[k] += 0.01;
    }
    both.Triangles.push_back({ 3 * f, 3 * f + 1, 3 * f + 2 });
    bodies.push_back(f % 2);
  }
  const std::vector<Id> near = FacetsNearOthers(both.Points, both.Triangles, bodies, 0);
  EXPECT_GT(near.size(), 0u);
  EXPECT_LT(near.size(), both.Triangles.size() / 2);
  const std::vector<Id> alone(bodies.size(), 0);
  EXPECT_EQ(FacetsNearOthers(both.Points, both.Triangles, alone, 0), std::vector<Id>());
  EXPECT_EQ(FacetsNearOthers({}, {}, {}, 0), std::vector<Id>());
}

TEST(FacetsNearNew, HoldAllThatBruteForceFinds)
{
  std::mt19937 random(5);
  for (int trial = 0; trial < 100; ++trial)
  {
    const TriangleSoup soup = AllSizes(random, 1 + trial * 5);
    const Id count = static_cast<Id>(soup.Triangles.size());
    const Id firstNew = std::uniform_int_distribution<Id>(0, count)(random);
    const std::vector<Id> near = FacetsNearNew(soup.Points, soup.Triangles, firstNew);
    EXPECT_TRUE(std::is_sorted(near.begin(), near.end()));
    const auto box = [&](Id f) { return BoundingBox(soup.Points, soup.Triangles[f]); };
    for (Id f = 0; f < count && firstNew < count; ++f)
    {
      bool isNear = f >= firstNew;
      for (Id g = firstNew; g < count && !isNear; ++g)
      {
        isNear = box(f).Meets(box(g));
      }
      EXPECT_TRUE(!isNear || std::binary_search(near.begin(), near.end(), f));
    }
  }
}

TEST(FacetsNearNew, AreFewWhereFewFacetsAreNew)
{
  std::mt19937 random(6);
  std::uniform_real_distribution<double> place(0, 1);
  TriangleSoup soup;
  for (Id f = 0; f < 2000; ++f)
  {
    const Point p = { place(random), place(random), place(random) };
    for (int k = 0; k < 3; ++k)
    {
      soup.Points.push_back(p);
      soup.Points.back()[k] += 0.01;
    }
    soup.Triangles.push_back({ 3 * f, 3 * f + 1, 3 * f + 2 });
  }
  const std::vector<Id> near = FacetsNearNew(soup.Points, soup.Triangles, 1990);
  EXPECT_GE(near.size(), 10u);
  EXPECT_LT(near.size(), 200u);
  EXPECT_EQ(FacetsNearNew(soup.Points, soup.Triangles, 2000), std::vector<Id>());
  EXPECT_EQ(FacetsNearNew(soup.Points, soup.Triangles, 0).size(), 2000u);
  EXPECT_EQ(FacetsNearNew({}, {}, 0), std::vector<Id>());
}
} // namespace
