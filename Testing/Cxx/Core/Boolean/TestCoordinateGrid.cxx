// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/CoordinateGrid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

namespace
{
using namespace insideout;

/** Points at random, each coordinate rounded. */
template <typename Rounding>
std::vector<Point> RoundedPoints(const Rounding& rounded)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-90, 90);
  std::vector<Point> points(40);
  for (Point& p : points)
  {
    for (double& x : p)
    {
      x = rounded(place(random));
    }
  }
  return points;
}

double Written(const char* format, double x)
{
  char text[64];
  std::snprintf(text, sizeof text, format, x);
  return std::strtod(text, nullptr);
}

TEST(CoordinateGrid, IsThatOfFloats)
{
  const auto grid =
    FindCoordinateGrid(RoundedPoints([](double x) { return static_cast<float>(x); }));
  ASSERT_TRUE(grid);
  EXPECT_EQ(grid->RoundingAt(1), std::ldexp(1.0, -24));
  EXPECT_EQ(grid->RoundingAt(-63.9), std::ldexp(1.0, -19));
  EXPECT_EQ(grid->RoundingAt(0), 0);
}

TEST(CoordinateGrid, IsThatOfDecimalsAlsoWhereTheyWereReadAsFloats)
{
  const auto six = FindCoordinateGrid(RoundedPoints([](double x) { return Written("%.6g", x); }));
  ASSERT_TRUE(six);
  EXPECT_NEAR(six->RoundingAt(50), 5e-5, 1e-18);
  const auto nine = FindCoordinateGrid(RoundedPoints([](double x) { return Written("%.9g", x); }));
  ASSERT_TRUE(nine);
  EXPECT_NEAR(nine->RoundingAt(50), 5e-8, 1e-20);
  const auto places =
    FindCoordinateGrid(RoundedPoints([](double x) { return Written("%.5f", x); }));
  ASSERT_TRUE(places);
  EXPECT_NEAR(places->RoundingAt(0.1), 5e-6, 1e-18);
  const auto read = FindCoordinateGrid(
    RoundedPoints([](double x) { return static_cast<float>(Written("%.6g", x)); }));
  ASSERT_TRUE(read);
  EXPECT_NEAR(read->RoundingAt(50), 5e-5, 1e-18);
}

TEST(CoordinateGrid, IsNotThatOfDoubles)
{
  EXPECT_FALSE(FindCoordinateGrid(RoundedPoints([](double x) { return x; })));
  EXPECT_FALSE(FindCoordinateGrid(RoundedPoints([](double x) { return Written("%.10g", x); })));
}

TEST(CoordinateGrid, IsThatOfFloatsForADesign)
{
  const auto grid = FindCoordinateGrid({ { 0, 0.1, 12.3456 }, { 20, 30.25, 40.4 } });
  ASSERT_TRUE(grid);
  EXPECT_EQ(grid->RoundingAt(1), std::ldexp(1.0, -24));
}
} // namespace
