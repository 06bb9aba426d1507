// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/ScaledPoints.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

using namespace insideout;

namespace
{
/** Any finite double, subnormal ones and both zeros too. */
double AnyFinite(std::mt19937_64& random)
{
  double x;
  do
  {
    const std::uint64_t bits = random() % 8 == 0 ? random() & 0x800FFFFFFFFFFFFFu : random();
    std::memcpy(&x, &bits, sizeof(x));
  } while (!std::isfinite(x));
  return x;
}

std::vector<Point> AnyPoints(std::mt19937_64& random, std::size_t count)
{
  std::vector<Point> points(count);
  for (Point& p : points)
  {
    p = { AnyFinite(random), AnyFinite(random), AnyFinite(random) };
  }
  return points;
}
} // namespace

TEST(ScaledPoints, AreRoundedOnceAsLdexpDoes)
{
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 500; ++trial)
  {
    const std::vector<Point> points = AnyPoints(random, 20);
    const int exponent = trial == 0 ? -1074
      : trial == 1                  ? 2046
                                    : static_cast<int>(random() % 3121) - 1074;
    const std::vector<Point> scaled = ScaledPoints(points, exponent);
    ASSERT_EQ(scaled.size(), points.size());
    for (std::size_t p = 0; p < points.size(); ++p)
    {
      for (int k = 0; k < 3; ++k)
      {
        const double expected = std::ldexp(points[p][k], exponent);
        ASSERT_EQ(std::memcmp(&scaled[p][k], &expected, sizeof(double)), 0)
          << points[p][k] << " times 2^" << exponent;
      }
    }
  }
}

TEST(ScaledPoints, AreBelowOneAndLosslessAtTheLargestExponent)
{
  std::mt19937_64 random(2);
  for (int trial = 0; trial < 500; ++trial)
  {
    // Sizes that differ by at most 2^900 do not underflow.
    const int size = static_cast<int>(random() % 1000) - 500;
    std::vector<Point> points(10);
    for (Point& p : points)
    {
      for (double& x : p)
      {
        x = std::ldexp(
          static_cast<double>(random() % 2001) - 1000, size + static_cast<int>(random() % 400));
      }
    }
    const int exponent = LargestExponent(points);
    const std::vector<Point> scaled = ScaledPoints(points, -exponent);
    const double largest = LargestCoordinate(scaled);
    EXPECT_LT(largest, 1);
    EXPECT_GE(largest, 0.5);
    EXPECT_EQ(ScaledPoints(scaled, exponent), points);
  }
}

TEST(ScaledPoints, KnowTheExtremes)
{
  const double largest = std::numeric_limits<double>::max();
  const double least = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(LargestExponent({}), 0);
  EXPECT_EQ(LargestExponent({ { 0, -0.0, 0 } }), 0);
  EXPECT_EQ(LargestExponent({ { 0, -1, 0 }, { 0.75, 0, 0 } }), 1);
  EXPECT_EQ(LargestExponent({ { 0, 0, -largest } }), 1024);
  EXPECT_EQ(LargestExponent({ { least, 0, 0 } }), -1073);
  EXPECT_EQ(ScaledPoints({ { least, 0, -least } }, 1073), (std::vector<Point>{ { 0.5, 0, -0.5 } }));
  EXPECT_EQ(ScaledPoints({ { 0.5, 0, 0 } }, -1073), (std::vector<Point>{ { least, 0, 0 } }));
  EXPECT_LT(ScaledPoints({ { largest, 0, 0 } }, -1024).front()[0], 1);
}
