// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/PolylineWindingNumber.h"

#include <gtest/gtest.h>
#include <quadmath.h>

#include <cmath>
#include <random>

namespace
{
using namespace insideout;

__extension__ typedef __float128 Quad;

/** The sum of the angles that the segments are seen under; 0 for those on a line with p. */
double SumInQuads(const std::vector<PlanarPoint>& points,
  const std::vector<CountedSegment>& segments, const PlanarPoint& p)
{
  Quad sum = 0;
  for (const CountedSegment& s : segments)
  {
    const Quad ux = Quad(points[s.From][0]) - p[0], uy = Quad(points[s.From][1]) - p[1];
    const Quad vx = Quad(points[s.To][0]) - p[0], vy = Quad(points[s.To][1]) - p[1];
    const Quad det = ux * vy - uy * vx;
    sum += det == 0 ? Quad(0) : s.Count * atan2q(det, ux * vx + uy * vy);
  }
  return static_cast<double>(sum / (8 * atanq(1)));
}

struct Polylines
{
  std::vector<PlanarPoint> Points;
  std::vector<CountedSegment> Segments;
};

/** A walk over random points of a grid, so that everything degenerate happens. */
Polylines RandomWalk(unsigned seed, int size, int steps, bool close)
{
  std::mt19937 random(seed);
  Polylines walk;
  for (int i = 0; i < steps; ++i)
  {
    walk.Points.push_back({ static_cast<double>(random() % size), double(random() % size) });
    const int count = random() % 4 == 0 ? 2 : 1;
    walk.Segments.push_back({ i, (i + 1) % steps, close ? 1 : count });
  }
  if (!close)
  {
    walk.Segments.erase(walk.Segments.begin() + steps / 2);
    walk.Segments.pop_back();
  }
  return walk;
}

TEST(PolylineWindingNumber, EqualsTheSumOfAnglesOnAndOffThePolylines)
{
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    const Polylines walk = RandomWalk(seed, 8, 5 + static_cast<int>(seed), seed % 2 == 0);
    const PolylineWindingNumber w(walk.Points, walk.Segments);
    EXPECT_EQ(w.IsClosed(), seed % 2 == 0);
    for (int x = -2; x <= 18; ++x)
    {
      for (int y = -2; y <= 18; ++y)
      {
        const PlanarPoint p = { x / 2.0, y / 2.0 };
        EXPECT_NEAR(w.At(p), SumInQuads(walk.Points, walk.Segments, p), 1e-14)
          << "seed " << seed << " at " << p[0] << ", " << p[1];
      }
    }
  }
}

TEST(PolylineWindingNumber, EqualsTheSumOfAnglesOfThousandsOfOpenEnds)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  Polylines many;
  for (int i = 0; i < 2000; ++i)
  {
    // Here and there clusters, of which some are tiny.
    const double size = std::pow(10.0, -(i % 12));
    const double x = std::floor(4 * uniform(random)) / 4;
    const double y = std::floor(4 * uniform(random)) / 4;
    many.Points.push_back({ x + size * uniform(random), y + size * uniform(random) });
    many.Points.push_back({ x + size * uniform(random), y + size * uniform(random) });
    many.Segments.push_back({ 2 * i, 2 * i + 1, 1 + i % 3 });
  }
  const PolylineWindingNumber w(many.Points, many.Segments);
  for (int i = 0; i < 400; ++i)
  {
    const PlanarPoint& near = many.Points[random() % many.Points.size()];
    const double distance = std::pow(10.0, -(i % 10));
    const PlanarPoint p = { near[0] + distance * (uniform(random) - 0.5),
      near[1] + distance * (uniform(random) - 0.5) };
    EXPECT_NEAR(w.At(p), SumInQuads(many.Points, many.Segments, p), 1e-11);
  }
}

TEST(PolylineWindingNumber, IsAskedAtTheExactMeanOfThreePoints)
{
  // A segment passes between the mean and what it is rounded to, for it is rounded to a corner.
  const double up = std::nextafter(1.0, 2.0);
  const std::vector<PlanarPoint> points = { { 0, 0 }, { 1, 1 }, { up, up }, { 1, up }, { 3, 0.5 },
    { 3, 3 }, { 0, 3 } };
  const PolylineWindingNumber w(
    points, { { 0, 1, 1 }, { 1, 4, 1 }, { 4, 5, 1 }, { 5, 6, 1 }, { 6, 0, 1 } });
  EXPECT_EQ(w.AtMean(points[1], points[2], points[3]), 1);
  EXPECT_EQ(w.AtMean({ 0, 0 }, { 1, 1 }, { 1, std::nextafter(1.0, 0.0) }), 0);
  EXPECT_EQ(w.AtMean({ 0, 0 }, { 1, 1 }, { 1, up }), 1);
}

/** Open ends nearer than the rounding of the mean: where they are from there is found exactly. */
TEST(PolylineWindingNumber, IsAskedAtTheExactMeanBesideOpenEnds)
{
  const double x = 0.3, y = 0.7;
  const double up = std::nextafter(y, 1), right = std::nextafter(x, 1);
  const std::vector<PlanarPoint> points = { { x, y }, { right, y }, { x, up }, { 0.9, 0.1 } };
  const std::vector<CountedSegment> segments = { { 3, 0, 1 }, { 1, 3, 2 }, { 2, 3, 1 } };
  const PolylineWindingNumber w(points, segments);
  Quad sum = 0;
  const std::array<Quad, 2> mean{ { (Quad(x) + right + x) / 3, (Quad(y) + y + up) / 3 } };
  for (const CountedSegment& s : segments)
  {
    const Quad ux = points[s.From][0] - mean[0], uy = points[s.From][1] - mean[1];
    const Quad vx = points[s.To][0] - mean[0], vy = points[s.To][1] - mean[1];
    sum += s.Count * atan2q(ux * vy - uy * vx, ux * vx + uy * vy);
  }
  EXPECT_NEAR(
    w.AtMean(points[0], points[1], points[2]), static_cast<double>(sum / (8 * atanq(1))), 1e-13);
}

TEST(PolylineWindingNumber, IsAWholeNumberOffClosedPolylines)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  Polylines circle;
  const int n = 1000;
  for (int i = 0; i < n; ++i)
  {
    const double angle = 4 * std::acos(-1) * i / n; // twice around
    circle.Points.push_back({ std::cos(angle) + 1e-3 * uniform(random), std::sin(angle) });
    circle.Segments.push_back({ i, (i + 1) % n, 1 });
  }
  const PolylineWindingNumber w(circle.Points, circle.Segments);
  Monitor monitor;
  std::vector<PlanarPoint> points;
  for (int i = 0; i < 1000; ++i)
  {
    points.push_back({ 4 * uniform(random) - 2, 4 * uniform(random) - 2 });
  }
  const std::vector<double> values = w.At(points, monitor);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const double radius = std::hypot(points[i][0], points[i][1]);
    EXPECT_EQ(values[i], std::round(values[i]));
    if (std::abs(radius - 1) > 0.01)
    {
      EXPECT_EQ(values[i], radius < 1 ? 2 : 0);
    }
  }
}

TEST(PolylineWindingNumber, IsTheMeanOnASegmentAndTheAngleInACorner)
{
  const std::vector<PlanarPoint> square = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
  const PolylineWindingNumber w(square, { { 0, 1, 1 }, { 1, 2, 1 }, { 2, 3, 1 }, { 3, 0, 1 } });
  EXPECT_EQ(w.At({ 0.5, 0.5 }), 1);
  EXPECT_EQ(w.At({ 0.5, 0 }), 0.5);
  EXPECT_EQ(w.At({ 1, 0.25 }), 0.5);
  EXPECT_EQ(w.At({ 0, 0.25 }), 0.5);
  EXPECT_EQ(w.At({ 0.25, 1 }), 0.5);
  for (const PlanarPoint& corner : square)
  {
    EXPECT_EQ(w.At(corner), 0.25);
  }
  EXPECT_EQ(w.At({ -1, 0 }), 0);
  EXPECT_EQ(w.At({ 2, 1 }), 0);
}

TEST(PolylineWindingNumber, TakesNothing)
{
  EXPECT_EQ(PolylineWindingNumber({}, {}).At(PlanarPoint{ 1, 2 }), 0);
  EXPECT_EQ(PolylineWindingNumber({ { 1, 2 } }, { { 0, 0, 1 } }).At(PlanarPoint{ 1, 2 }), 0);
}
} // namespace
