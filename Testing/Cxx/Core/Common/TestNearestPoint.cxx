// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/NearestPoint.h"

#include "Common/Vectors.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

using namespace insideout;

namespace
{
constexpr double Any = std::numeric_limits<double>::infinity();

double SquaredDistanceOf(const std::array<Point, 3>& triangle, const Point& place)
{
  const Point apart = Difference(NearestPointOf(triangle, place), place);
  return Dot(apart, apart);
}

/** A triangle whose third corner is a fraction of its longest edge away from that edge. */
std::array<Point, 3> TriangleOf(double height, const Point& a, const Point& b, const Point& c)
{
  const Point across = NearestPointOf({ { a, b, a } }, c);
  Point corner;
  for (int axis = 0; axis < 3; ++axis)
  {
    corner[axis] = across[axis] + height * (c[axis] - across[axis]);
  }
  return { { a, b, corner } };
}
} // namespace

TEST(SquaredDistances, AreThoseOfNearestPoints)
{
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> any(-1, 1);
  const auto place = [&] { return Point{ { any(engine), any(engine), any(engine) } }; };
  for (const double height : { 1.0, 0.1, 1e-3, 1e-9, 0.0 })
  {
    for (int turn = 0; turn < 200; ++turn)
    {
      const std::array<Point, 3> triangle = TriangleOf(height, place(), place(), place());
      const SquaredDistances distances(triangle);
      for (int k = 0; k < 20; ++k)
      {
        const Point from = place();
        const double squared = SquaredDistanceOf(triangle, from);
        EXPECT_NEAR(distances.To(from, Any), squared, 1e-9 * squared) << height;
        EXPECT_GE(distances.To(from, squared / 2), squared / 2) << height;
      }
      const Point corner = triangle[turn % 3];
      EXPECT_NEAR(distances.To(corner, Any), SquaredDistanceOf(triangle, corner), 1e-24) << height;
    }
  }
}

TEST(SquaredDistances, AreThoseFromAPointWhereTheTriangleIsOne)
{
  const Point point = { { 1, 2, 3 } };
  const SquaredDistances distances(std::array<Point, 3>{ { point, point, point } });
  EXPECT_EQ(distances.To({ { 1, 2, 5 } }, Any), 4);
}
