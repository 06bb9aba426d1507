// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/FindPlane.h"

#include "Common/Error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace insideout;

TEST(FindPlane, GivesPointsBackBitByBitInPlanesAlongAxes)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<Point> points;
    for (const auto& [x, y] :
      { std::pair(0.1, 0.2), std::pair(1e5 / 3, 0.7), std::pair(-5.3, 1e-7) })
    {
      Point p;
      p[axis] = 0.3;
      p[(axis + 1) % 3] = x;
      p[(axis + 2) % 3] = y;
      points.push_back(p);
    }
    const Plane plane = FindPlane(points);
    EXPECT_EQ(plane.Dropped, axis);
    EXPECT_EQ(plane.Distance, 0);
    EXPECT_TRUE(plane.Metric.IsPerpendicular());
    EXPECT_EQ(plane.Normal[axis], 1);
    for (const Point& p : points)
    {
      EXPECT_EQ(plane.Lift(plane.Project(p)), p);
      EXPECT_EQ(plane.Turned().Lift(plane.Turned().Project(p)), p);
    }
  }
}

TEST(FindPlane, MeasuresInPlanesThatLean)
{
  const std::vector<Point> points = { { { 0, 0, 0 } }, { { 1, 0, -1 } }, { { 0, 1, -1 } },
    { { 3, 2, -5 } } };
  const Plane plane = FindPlane(points);
  EXPECT_EQ(plane.Distance, 0);
  const double scale = std::ldexp(1.0, plane.Exponent);
  for (const Point& p : points)
  {
    for (const Point& q : points)
    {
      EXPECT_NEAR(scale * plane.Metric.Distance(plane.Project(p), plane.Project(q)),
        std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]), 1e-14);
    }
  }
  const Point above = { { 2, 2, 2 } };
  const Point foot = plane.Foot(above);
  EXPECT_NEAR(foot[0] + foot[1] + foot[2], 0, 1e-14);
  EXPECT_NEAR(foot[0] - foot[1], 0, 1e-14);
}

TEST(FindPlane, TakesTheSameAxesForRoundedPointsAtEqualSlopes)
{
  for (const double y : { 0.0, 1.0, -1.0 })
  {
    for (const double z : { 1 - 1e-15, 1.0, 1 + 1e-15 })
    {
      const Plane plane = FindPlane({ { { 0, 0, 0 } }, { { 1, y, z } }, { { 0, 1, 0 } } });
      EXPECT_EQ(plane.Dropped, 0) << y << " " << z;
      EXPECT_GT(plane.Normal[0], 0);
    }
  }
}

TEST(FindPlane, TellsRoundingFromWhatIsNotFlat)
{
  std::vector<Point> rounded;
  std::vector<Point> bent;
  for (int i = 0; i < 50; ++i)
  {
    const double x = std::cos(0.1 * i);
    const double y = std::sin(0.3 * i);
    rounded.push_back({ { x, y, 0.3 * x + 0.7 * y } });
    bent.push_back({ { x, y, 1e-4 * x * y } });
  }
  EXPECT_GT(FindPlane(rounded).Distance, 0);
  EXPECT_LT(FindPlane(rounded).Distance, RoundingOfDoubles);
  EXPECT_GT(FindPlane(bent).Distance, RoundingOfSingles);
}

TEST(FindPlane, TakesNoLineForAPlane)
{
  EXPECT_THROW(FindPlane({}), Error);
  EXPECT_THROW(FindPlane({ { { 1, 2, 3 } } }), Error);
  EXPECT_THROW(FindPlane({ { { 0, 0, 0 } }, { { 1, 2, 3 } }, { { 2, 4, 6 } } }), Error);
}
} // namespace
