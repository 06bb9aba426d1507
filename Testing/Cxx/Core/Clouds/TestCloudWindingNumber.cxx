// SPDX-License-Identifier: GPL-3.0-or-later
#include "Clouds/CloudWindingNumber.h"

#include "Common/Vectors.h"
#include "Support/Clouds.h"
#include "Support/StopAtEveryReport.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace
{
using namespace insideout;
using testmeshes::Sphere;

PointCloud Checked(const PointCloud& cloud)
{
  Monitor silent;
  return CheckedCloud(cloud, silent, { "", 0, 1 });
}

/** Points, normals and areas at random, in clusters of different sizes; of areas some are 0. */
PointCloud RandomCloud(unsigned seed, int count)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  PointCloud cloud;
  Point centre = { 0, 0, 0 };
  double size = 1;
  for (int i = 0; i < count; ++i)
  {
    if (i % 50 == 0)
    {
      centre = { number(random), number(random), number(random) };
      size = std::pow(10, 3 * number(random) - 3);
    }
    Point point = centre;
    Point normal;
    for (int axis = 0; axis < 3; ++axis)
    {
      point[axis] += size * number(random);
      normal[axis] = number(random);
    }
    cloud.Points.push_back(point);
    cloud.Normals.push_back(normal);
    cloud.Areas.push_back(i % 7 == 0 ? 0 : size * size * (1 + number(random)));
  }
  return Checked(cloud);
}

struct Sums
{
  double W;          ///< the formula as it stands, in long doubles
  double Magnitudes; ///< of areas over 4 pi times squared distances
};

Sums SumsOf(const PointCloud& cloud, const Point& place)
{
  const long double pi = std::acos(-1.0L);
  long double w = 0;
  long double magnitudes = 0;
  for (std::size_t i = 0; i < cloud.Points.size(); ++i)
  {
    if (cloud.Areas[i] == 0)
    {
      continue;
    }
    Vector<long double> r;
    Vector<long double> n;
    for (int axis = 0; axis < 3; ++axis)
    {
      r[axis] = static_cast<long double>(cloud.Points[i][axis]) - place[axis];
      n[axis] = cloud.Normals[i][axis];
    }
    const long double length = std::max(std::sqrt(Dot(r, r)), std::sqrt(cloud.Areas[i] / pi));
    w += cloud.Areas[i] * Dot(n, r) / (4 * pi * length * length * length);
    magnitudes += cloud.Areas[i] / (4 * pi * length * length);
  }
  return { static_cast<double>(w), static_cast<double>(magnitudes) };
}

/** Around the points of a cloud, near and far, and on them. */
std::vector<Point> PlacesAround(const PointCloud& cloud, unsigned seed, int count)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  std::uniform_int_distribution<std::size_t> some(0, cloud.Points.size() - 1);
  std::vector<Point> places;
  for (int i = 0; i < count; ++i)
  {
    Point place = cloud.Points[some(random)];
    const double away = i % 10 == 0 ? 0 : std::pow(10, 3 * number(random) - 2);
    for (double& x : place)
    {
      x += away * number(random);
    }
    places.push_back(place);
  }
  return places;
}

TEST(CloudWindingNumber, IsNeverFartherFromTheSumThanItSays)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    const PointCloud cloud = seed == 0 ? Checked(Sphere(1500, 1)) : RandomCloud(seed, 1000);
    const CloudWindingNumber tree(cloud, false);
    const CloudWindingNumber sum(cloud, true);
    double most = 0; // of what may be
    for (const Point& place : PlacesAround(cloud, seed, 200))
    {
      const Sums expected = SumsOf(cloud, place);
      EXPECT_NEAR(sum.At(place), expected.W, 1e-11);
      most = std::max(most,
        std::abs(tree.At(place) - expected.W) /
          (CloudWindingNumber::Accuracy * expected.Magnitudes));
    }
    EXPECT_LE(most, 1) << seed;
    EXPECT_GT(most, 1e-6) << "the tree passed nothing over";
  }
}

TEST(CloudWindingNumber, IsOneWithinASphereAndZeroOutside)
{
  const PointCloud cloud = Checked(Sphere(5000, 3));
  const CloudWindingNumber w(cloud, false);
  std::mt19937 random(1);
  std::normal_distribution<double> number;
  for (int i = 0; i < 500; ++i)
  {
    Point place = { number(random), number(random), number(random) };
    const double radius = 3.0 * i / 250;
    const double length = Length(place);
    for (double& x : place)
    {
      x *= radius / length;
    }
    // Points are some 0.15 apart.
    if (std::abs(radius - 3) > 0.3)
    {
      EXPECT_NEAR(w.At(place), radius < 3 ? 1 : 0, 0.02) << radius;
    }
  }
}

TEST(CloudWindingNumber, HasNoStepAndNoPeakBesideAPoint)
{
  PointCloud one;
  one.Points = { { 5, 6, 7 } };
  one.Normals = { { 0, 0, 1 } };
  one.Areas = { Pi }; // of radius 1
  const CloudWindingNumber w(one, false);
  EXPECT_EQ(w.At({ 5, 6, 7 }), 0);
  EXPECT_NEAR(w.At({ 5, 6, 6 }), 0.25, 1e-15);
  EXPECT_NEAR(w.At({ 5, 6, 8 }), -0.25, 1e-15);
  EXPECT_NEAR(w.At({ 5, 6, 6.5 }), 0.125, 1e-15);
  EXPECT_NEAR(w.At({ 5, 6, 5 }), 1.0 / 16, 1e-15);
  EXPECT_NEAR(w.At({ 5, 6, 6 + 1e-9 }), w.At({ 5, 6, 6 - 1e-9 }), 1e-8);
}

TEST(CloudWindingNumber, HasTheGradientThatDifferencesHave)
{
  const PointCloud cloud = RandomCloud(3, 1000);
  const CloudWindingNumber sum(cloud, true);
  const CloudWindingNumber tree(cloud, false);
  const double step = 1e-6;
  int compared = 0;
  for (const Point& place : PlacesAround(cloud, 5, 300))
  {
    const Point exact = sum.Gradient(place);
    const Point gradient = tree.Gradient(place);
    EXPECT_LE(Length(Difference(gradient, exact)), 0.05 * Length(exact) + 0.05);
    Point differences;
    for (int axis = 0; axis < 3; ++axis)
    {
      Point ahead = place;
      Point behind = place;
      ahead[axis] += step;
      behind[axis] -= step;
      differences[axis] = (SumsOf(cloud, ahead).W - SumsOf(cloud, behind).W) / (2 * step);
    }
    double nearest = 1;
    for (const Point& point : cloud.Points)
    {
      nearest = std::min(nearest, Distance(point, place));
    }
    if (nearest > 0.01)
    {
      ++compared;
      EXPECT_LE(Length(Difference(exact, differences)), 1e-5 * Length(exact) + 1e-7);
    }
  }
  EXPECT_GT(compared, 50);
}

TEST(CloudWindingNumber, IsTheSameOneByOneAndForAllAndWhereverUnitsAre)
{
  const PointCloud cloud = RandomCloud(4, 500);
  const CloudWindingNumber w(cloud, false);
  std::vector<Point> places = PlacesAround(cloud, 6, 100);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  places.push_back({ 0, nan, 0 });
  places.push_back({ 1e300, 0, 0 });
  Monitor silent;
  const std::vector<double> values = w.At(places, silent, { "", 0, 1 });
  PointCloud small = cloud;
  for (std::size_t i = 0; i < small.Points.size(); ++i)
  {
    for (double& x : small.Points[i])
    {
      x = std::ldexp(x, -300);
    }
    small.Areas[i] = std::ldexp(small.Areas[i], -600);
  }
  const CloudWindingNumber ofSmall(small, false);
  for (int i = 0; i < 100; ++i)
  {
    EXPECT_EQ(values[i], w.At(places[i]));
    const Point& p = places[i];
    EXPECT_EQ(values[i],
      ofSmall.At({ std::ldexp(p[0], -300), std::ldexp(p[1], -300), std::ldexp(p[2], -300) }));
  }
  EXPECT_TRUE(std::isnan(values[100]));
  EXPECT_EQ(values[101], 0);
  EXPECT_EQ(w.Gradient(places[100]), (Point{ 0, 0, 0 }));
}

TEST(CloudWindingNumber, TakesAreasFarLargerThanTheCloud)
{
  for (const double size : { 1e-160, 1e-20, 1.0 })
  {
    for (const double area : { 1.0, 1e308 })
    {
      PointCloud cloud = Sphere(200, size);
      cloud.Normals.assign(200, { 0, 0, 1 });
      cloud.Areas.assign(200, area);
      const double away = 3 * std::sqrt(area);
      const Point place = { away / 10, 0, -away };
      const Sums expected = SumsOf(cloud, place);
      EXPECT_GT(expected.W, 1);
      for (const bool sums : { false, true })
      {
        EXPECT_NEAR(CloudWindingNumber(Checked(cloud), sums).At(place), expected.W,
          CloudWindingNumber::Accuracy * expected.Magnitudes)
          << size << " " << area;
      }
    }
  }
}

TEST(CloudWindingNumber, CanBeStoppedAtEachReport)
{
  const PointCloud cloud = RandomCloud(5, 200);
  const CloudWindingNumber w(cloud, false);
  const std::vector<Point> places = PlacesAround(cloud, 7, 100);
  EXPECT_GT(testmeshes::StopAtEveryReport([&](Monitor& monitor, const ProgressRange& progress)
              { w.At(places, monitor, progress); }),
    1);
}
} // namespace
