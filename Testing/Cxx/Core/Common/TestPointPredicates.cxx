// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/PointPredicates.h"

#include "Support/RationalVectors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace insideout;

namespace
{
/** Points that rounding leaves within a few bits of one plane, now and then exactly in it. */
class NearlyFlat
{
public:
  Point operator()()
  {
    const double x = this->Coordinate(this->Random);
    const double y = this->Coordinate(this->Random);
    const double off = static_cast<double>(this->Random() % 5) - 2;
    return { x, y, x / 3 + y / 7 + std::ldexp(off, -53) };
  }

private:
  std::mt19937 Random{ 1 };
  std::uniform_real_distribution<double> Coordinate{ 0.25, 1 };
};

int Sign(const testmeshes::Rational& x)
{
  return (x > 0) - (x < 0);
}

int ExactOrientation(const std::vector<Point>& p)
{
  const auto edge = [&p](int k)
  { return testmeshes::Minus(testmeshes::Exact(p[k]), testmeshes::Exact(p[0])); };
  return Sign(testmeshes::Dot(testmeshes::Cross(edge(1), edge(2)), edge(3)));
}
} // namespace

TEST(Orient3D, IsExactWhereDoublesAreNot)
{
  NearlyFlat point;
  int apart = 0;
  for (int trial = 0; trial < 2000; ++trial)
  {
    const std::vector<Point> p = { point(), point(), point(),
      trial % 10 == 0 ? Point{ 0.5, 0.5, 0.5 } : point() };
    const int expected = ExactOrientation(p);
    EXPECT_EQ(Orient3D(p, { 0, 1, 2, 3 }), expected);
    EXPECT_EQ(Orient3D(p[1], p[0], p[2], p[3]), -expected);
    EXPECT_EQ(Orient3D(p, { 0, 1, 2, 1 }), 0);
    apart += std::abs(expected);
  }
  EXPECT_GT(apart, 1000);
}

TEST(Orient3D, IsExactForRectanglesOfWhatIsExtrudedAndBesideThem)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  int flat = 0;
  for (int trial = 0; trial < 6000; ++trial)
  {
    // All points with coordinates that are few: many are the same, or a rounding apart.
    std::array<std::array<double, 3>, 3> few;
    for (std::array<double, 3>& values : few)
    {
      const double size = std::ldexp(1, static_cast<int>(random() % 3) * 100 - 100);
      values = { { size * coordinate(random), size * coordinate(random), 0 } };
      values[2] = random() % 2 == 0 ? 0 : std::nextafter(values[0], size);
    }
    std::vector<Point> p(4);
    for (Point& point : p)
    {
      for (int k = 0; k < 3; ++k)
      {
        point[k] = few[k][random() % 3];
      }
    }
    const int expected = ExactOrientation(p);
    EXPECT_EQ(Orient3D(p, { 0, 1, 2, 3 }), expected);
    flat += expected == 0 ? 1 : 0;
  }
  EXPECT_GT(flat, 1000);
  EXPECT_LT(flat, 5000);
}

TEST(Orient3D, IsExactWhereProductsOverOrUnderflow)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int trial = 0; trial < 500; ++trial)
  {
    std::vector<Point> p(4);
    for (Point& point : p)
    {
      for (double& x : point)
      {
        x = std::ldexp(coordinate(random), static_cast<int>(random() % 2040) - 1030);
      }
    }
    EXPECT_EQ(Orient3D(p, { 0, 1, 2, 3 }), ExactOrientation(p));
  }
}

TEST(Orient3D, IsPositiveWhereTheFirstThreeRunCounterClockwiseSeenFromTheFourth)
{
  EXPECT_EQ(Orient3D({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }), 1);
}

TEST(Orient2D, IsPositiveOnTheLeft)
{
  EXPECT_EQ(Orient2D({ 0, 0 }, { 1, 0 }, { 0, 1 }), 1);
  EXPECT_EQ(Orient2D({ 0, 0 }, { 1, 0 }, { 0, -1 }), -1);
  // 3 * 0.1 is not 0.3.
  EXPECT_NE(Orient2D({ 0, 0 }, { 1, 0.1 }, { 3, 0.3 }), 0);
  EXPECT_EQ(Orient2D({ 0, 0 }, { 1, 0.1 }, { 4, 4 * 0.1 }), 0);
}

TEST(IsDegenerate, IsSoWithEqualPointsAndOnALine)
{
  const std::vector<Point> points = { { 0, 0, 0 }, { 1, 0.1, 0 }, { 4, 4 * 0.1, 0 },
    { 3, 3 * 0.1, 0 }, { 4, 4 * 0.1, 0 } };
  EXPECT_TRUE(IsDegenerate(points, { 0, 1, 1 }));
  EXPECT_TRUE(IsDegenerate(points, { 2, 0, 4 }));
  EXPECT_TRUE(IsDegenerate(points, { 0, 1, 2 }));
  EXPECT_FALSE(IsDegenerate(points, { 0, 1, 3 })); // 3 * 0.1 is rounded, 4 * 0.1 is not
}
