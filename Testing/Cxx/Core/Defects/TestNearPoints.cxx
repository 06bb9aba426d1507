// SPDX-License-Identifier: GPL-3.0-or-later
#include "Defects/NearPoints.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace insideout;

namespace
{
Id CountByBruteForce(const std::vector<Point>& points, double distance)
{
  Id count = 0;
  for (const Point& p : points)
  {
    bool near = false;
    for (const Point& q : points)
    {
      near = near || (&p != &q && std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) < distance);
    }
    count += near;
  }
  return count;
}

/** Points in a box of the given size, of which every other one is near the one before it. */
std::vector<Point> Pairs(unsigned seed, int count, double step, double offset)
{
  std::mt19937 random(seed);
  const auto number = [&]() { return random() / 4294967296.0; };
  std::vector<Point> points = { { offset, offset, offset },
    { offset + 1, offset + 1, offset + 1 } };
  for (int i = 0; i < count; ++i)
  {
    points.push_back({ offset + number(), offset + number(), offset + number() });
    Point near = points.back();
    for (double& x : near)
    {
      x += step * (2 * number() - 1);
    }
    points.push_back(near);
  }
  return points;
}
} // namespace

TEST(NearPoints, AreThoseThatBruteForceFinds)
{
  for (unsigned seed = 0; seed < 40; ++seed)
  {
    for (const double fraction : { 1e-6, 1e-3, 0.1 })
    {
      const std::vector<Point> points = Pairs(seed, 60, 2 * fraction, seed % 2 ? 1e3 : 0);
      const NearPoints near = FindNearPoints(points, fraction);
      ASSERT_EQ(near.Count, CountByBruteForce(points, near.Distance)) << "seed " << seed;
      ASSERT_GT(near.Count, 0);
      if (fraction < 0.01)
      {
        ASSERT_LT(near.Count, 120) << "some are too far apart";
      }
    }
  }
}

TEST(NearPoints, AreTheSameAtEveryScale)
{
  const std::vector<Point> points = Pairs(1, 50, 2e-6, 0);
  const NearPoints expected = FindNearPoints(points, 1e-6);
  EXPECT_NEAR(expected.Distance, 1e-6 * std::sqrt(3.0), 1e-11);
  for (const int exponent : { -900, -100, 100, 900 })
  {
    std::vector<Point> scaled = points;
    for (Point& p : scaled)
    {
      p = { std::ldexp(p[0], exponent), std::ldexp(p[1], exponent), std::ldexp(p[2], exponent) };
    }
    const NearPoints near = FindNearPoints(scaled, 1e-6);
    EXPECT_EQ(near.Count, expected.Count);
    EXPECT_EQ(near.Distance, std::ldexp(expected.Distance, exponent));
  }
}

TEST(NearPoints, CopeWithTheLargestAndTheSmallestNumbers)
{
  const double largest = std::numeric_limits<double>::max();
  const double smallest = std::numeric_limits<double>::denorm_min();
  const double next = std::nextafter(largest, 0.0);
  EXPECT_EQ(
    FindNearPoints({ { -largest, 0, 0 }, { largest, 0, 0 }, { next, 0, 0 } }, 1e-6).Count, 2);
  EXPECT_EQ(
    FindNearPoints({ { 0, 0, 0 }, { smallest, 0, 0 }, { 2 * smallest, 0, 0 } }, 1e-6).Count, 0);
  EXPECT_EQ(FindNearPoints({ { 1, 2, 3 } }, 1e-6).Count, 0);
  EXPECT_EQ(FindNearPoints({}, 1e-6).Count, 0);
}

TEST(NearPoints, AreFoundQuicklyInACluster)
{
  std::vector<Point> points = Pairs(1, 50000, 0, 0);
  for (std::size_t i = 2; i < points.size(); ++i)
  {
    for (double& x : points[i])
    {
      x *= 1e-7; // all of them nearer to each other than the radius
    }
    points[i][0] += 1e-16 * static_cast<double>(i);
  }
  EXPECT_EQ(FindNearPoints(points, 1e-6).Count, static_cast<Id>(points.size()) - 1);
}
