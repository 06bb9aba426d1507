// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/SurfaceWindingNumber.h"

#include "Common/Team.h"
#include "Support/Corpus.h"
#include "Support/TestMeshes.h"
#include "Support/WindingNumberInQuads.h"
#include "Validate/CountedChain.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <cstring>

namespace
{
using namespace insideout;

double SumInQuads(const FacetComplex& surface, const Point& p)
{
  return testmeshes::WindingNumberInQuads(surface, SiteAt(p));
}

FacetComplex Counted(const TriangleSoup& soup)
{
  Monitor monitor;
  return CountFacets(soup, {}, monitor).Surface;
}

/** A ball with integer coordinates, as a box whose faces are cut into n x n squares, bent. */
TriangleSoup Ball(int n, double size)
{
  TriangleSoup soup;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int side : { -1, 1 })
    {
      const Id first = static_cast<Id>(soup.Points.size());
      for (int i = 0; i <= n; ++i)
      {
        for (int j = 0; j <= n; ++j)
        {
          Point p;
          p[axis] = side;
          p[(axis + 1) % 3] = 2.0 * i / n - 1;
          p[(axis + 2) % 3] = 2.0 * j / n - 1;
          const double length = std::hypot(p[0], p[1], p[2]);
          for (double& x : p)
          {
            x = std::round(size * x / length);
          }
          soup.Points.push_back(p);
        }
      }
      for (int i = 0; i < n; ++i)
      {
        for (int j = 0; j < n; ++j)
        {
          const Id a = first + i * (n + 1) + j;
          const Id b = a + n + 1;
          Triangle s = { { a, b, b + 1 } };
          Triangle t = { { a, b + 1, a + 1 } };
          if (side < 0)
          {
            std::swap(s[1], s[2]);
            std::swap(t[1], t[2]);
          }
          soup.Triangles.push_back(s);
          soup.Triangles.push_back(t);
        }
      }
    }
  }
  return testmeshes::Merged(soup);
}

/** The soup less some facets: single ones and a run of them. */
TriangleSoup WithHoles(TriangleSoup soup, unsigned seed)
{
  std::mt19937 random(seed);
  for (int i = 0; i < 3; ++i)
  {
    soup.Triangles.erase(
      soup.Triangles.begin() + static_cast<std::ptrdiff_t>(random() % soup.Triangles.size()));
  }
  soup.Triangles.erase(soup.Triangles.begin(),
    soup.Triangles.begin() + static_cast<std::ptrdiff_t>(soup.Triangles.size() / 16));
  return soup;
}

struct Family
{
  const char* Name;
  FacetComplex Surface;
};

/** Closed, open, crossing itself, non-manifold, soups. Coordinates are small whole numbers, so that
 * quadruple precision knows exactly what lies in a plane. */
std::vector<Family> Families()
{
  using namespace testmeshes;
  const TriangleSoup ball = Ball(8, 64);
  TriangleSoup boxes = Join(Box({ 0, 0, 0 }, { 32, 32, 32 }), Box({ 16, 16, 16 }, { 48, 40, 56 }));
  boxes = Merged(Join(boxes, Reversed(Box({ 32, 0, 0 }, { 64, 32, 8 }))));
  TriangleSoup nested = Join(ball, Reversed(Ball(4, 32)));
  TriangleSoup soup = GridSoup(3, 150, 32);
  TriangleSoup twice = Join(ball, soup);
  return { { "ball", Counted(ball) }, { "ball with holes", Counted(WithHoles(ball, 1)) },
    { "boxes", Counted(boxes) }, { "boxes with holes", Counted(WithHoles(boxes, 2)) },
    { "nested balls", Counted(nested) }, { "nested with holes", Counted(WithHoles(nested, 3)) },
    { "soup", Counted(soup) }, { "ball and soup", Counted(twice) },
    { "one triangle",
      Counted({ { { 0, 0, 0 }, { 8, 0, 0 }, { 0, 8, 4 } }, { { { 0, 1, 2 } } } }) } };
}

/** At random, on vertices, edges and facets, and on the lines through edges. */
std::vector<Point> PointsAround(const FacetComplex& surface, unsigned seed, int ofEach)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-80, 80);
  std::vector<Point> points;
  for (int i = 0; i < ofEach; ++i)
  {
    points.push_back({ uniform(random), uniform(random), uniform(random) });
    points.push_back({ std::round(uniform(random)), std::round(uniform(random)), 0 });
    const Triangle& t = surface.Facets[random() % surface.Facets.size()];
    const Point& a = surface.Points[t[0]];
    const Point& b = surface.Points[t[1]];
    const Point& c = surface.Points[t[2]];
    const auto combine = [&](double u, double v, double w)
    {
      Point p;
      for (int axis = 0; axis < 3; ++axis)
      {
        p[axis] = u * a[axis] + v * b[axis] + w * c[axis];
      }
      points.push_back(p);
    };
    combine(1, 0, 0);
    combine(0.5, 0.5, 0);
    combine(0, 0.75, 0.25);
    combine(0.25, 0.25, 0.5);
    combine(1e-3 * 0x1p-4, 0.5, 0.5); // rounded: next to the facet
    combine(2, -1, 0);
    combine(0, -0.5, 1.5);
  }
  return points;
}

std::vector<double> Evaluate(
  const FacetComplex& surface, const std::vector<Point>& points, WindingNumberMethod method)
{
  Monitor monitor;
  return SurfaceWindingNumber(surface, { method }, monitor).At(points, monitor);
}

TEST(SurfaceWindingNumber, EqualsQuadruplePrecisionOnAndOffTheSurface)
{
  for (const Family& family : Families())
  {
    const std::vector<Point> points = PointsAround(family.Surface, 5, 25);
    std::vector<double> expected;
    for (const Point& p : points)
    {
      expected.push_back(SumInQuads(family.Surface, p));
    }
    for (const WindingNumberMethod method :
      { WindingNumberMethod::Exact, WindingNumberMethod::Naive, WindingNumberMethod::Hierarchical })
    {
      const std::vector<double> w = Evaluate(family.Surface, points, method);
      for (std::size_t i = 0; i < points.size(); ++i)
      {
        EXPECT_NEAR(w[i], expected[i], 1e-12)
          << family.Name << ", method " << static_cast<int>(method) << ", at " << points[i][0]
          << ", " << points[i][1] << ", " << points[i][2];
      }
    }
  }
}

/** A vertex 5e-18 beside an edge: its facet there is a needle, and rounded unit vectors to the
 * needle's ends are opposite. */
TEST(SurfaceWindingNumber, KeepsItsDigitsAtTheBluntCornerOfANeedle)
{
  const TriangleSoup soup = testmeshes::CorpusSurface("blunt-corner-of-a-needle");
  const FacetComplex surface = Counted(soup);
  const std::vector<double> w = Evaluate(surface, soup.Points, WindingNumberMethod::Exact);
  for (std::size_t p = 0; p < soup.Points.size(); ++p)
  {
    EXPECT_NEAR(w[p], SumInQuads(surface, soup.Points[p]), 1e-12) << "at point " << p;
  }
}

TEST(SurfaceWindingNumber, IsTheSameForOnePointAndForMany)
{
  Monitor monitor;
  for (const Family& family : Families())
  {
    const std::vector<Point> points = PointsAround(family.Surface, 6, 1);
    for (int method = 0; method < 4; ++method)
    {
      const SurfaceWindingNumber w(
        family.Surface, { static_cast<WindingNumberMethod>(method) }, monitor);
      const std::vector<double> values = w.At(points, monitor);
      for (std::size_t i = 0; i < points.size(); ++i)
      {
        EXPECT_NEAR(w.At(points[i]), values[i], 1e-14) << family.Name << ", method " << method;
      }
    }
  }
}

TEST(SurfaceWindingNumber, IsAnExactIntegerOffClosedSurfaces)
{
  for (const Family& family : Families())
  {
    Monitor monitor;
    const SurfaceWindingNumber exact(family.Surface, {}, monitor);
    std::mt19937 random(8);
    std::uniform_real_distribution<double> uniform(-80, 80);
    for (int i = 0; exact.IsClosed() && i < 1000; ++i)
    {
      const double w = exact.At(Point{ uniform(random), uniform(random), uniform(random) });
      EXPECT_EQ(w, std::round(w)) << family.Name;
    }
  }
}

TEST(SurfaceWindingNumber, IsTheAngleOnABoxesFacesEdgesAndCorners)
{
  const FacetComplex box = Counted(testmeshes::Box({ 0, 0, 0 }, { 1, 1, 1 }));
  Monitor monitor;
  const SurfaceWindingNumber w(box, {}, monitor);
  EXPECT_NEAR(w.At(Point{ 0.5, 0.25, 0 }), 0.5, 1e-15);
  EXPECT_NEAR(w.At(Point{ 0.5, 0.5, 1 }), 0.5, 1e-15); // on a diagonal
  EXPECT_NEAR(w.At(Point{ 0.25, 0, 0 }), 0.25, 1e-15);
  EXPECT_NEAR(w.At(Point{ 1, 1, 1 }), 0.125, 1e-15);
  EXPECT_EQ(w.At(Point{ 0.5, 0.25, 1e-300 }), 1);
  EXPECT_EQ(w.At(Point{ 0.5, 0.25, -1e-300 }), 0);
}

TEST(SurfaceWindingNumber, ApproximatesBetterWithOrderAndAccuracy)
{
  Monitor monitor;
  const FacetComplex surface = Counted(WithHoles(Ball(16, 64), 1));
  std::mt19937 random(9);
  std::uniform_real_distribution<double> uniform(-80, 80);
  std::vector<Point> points;
  for (int i = 0; i < 2000; ++i)
  {
    points.push_back({ uniform(random), uniform(random), uniform(random) });
  }
  const std::vector<double> exact = Evaluate(surface, points, WindingNumberMethod::Exact);
  const auto meanError = [&](int order, double accuracy)
  {
    const SurfaceWindingNumber w(
      surface, { WindingNumberMethod::Approximate, order, accuracy }, monitor);
    const std::vector<double> values = w.At(points, monitor);
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      sum += std::abs(values[i] - exact[i]) / static_cast<double>(points.size());
    }
    return sum;
  };
  EXPECT_LT(meanError(2, 2), 1e-2); // the usual setting
  for (int order : { 1, 2, 3 })
  {
    EXPECT_LT(meanError(order, 8), meanError(order, 2) / std::pow(4, order)) << "order " << order;
  }
  EXPECT_LT(meanError(3, 8), meanError(2, 8) / 10);
  EXPECT_LT(meanError(3, 8), meanError(1, 8) / 10);
  EXPECT_LT(meanError(1, 1e9), 1e-13); // all facets are near
}

TEST(SurfaceWindingNumber, RefusesOtherOrdersAndAccuracies)
{
  Monitor monitor;
  const FacetComplex box = Counted(testmeshes::Box({ 0, 0, 0 }, { 1, 1, 1 }));
  for (const WindingNumberParameters& wrong :
    { WindingNumberParameters{ WindingNumberMethod::Approximate, 0, 2 },
      WindingNumberParameters{ WindingNumberMethod::Approximate, 4, 2 },
      WindingNumberParameters{ WindingNumberMethod::Approximate, 2, 0.5 },
      WindingNumberParameters{ WindingNumberMethod::Approximate, 2, std::nan("") } })
  {
    try
    {
      const SurfaceWindingNumber w(box, wrong, monitor);
      ADD_FAILURE();
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.Code, ErrorCode::InvalidParameter);
    }
  }
}

TEST(SurfaceWindingNumber, HasTheGradientOfItsDifferencesAndNoneWhereClosed)
{
  Monitor monitor;
  for (const Family& family : Families())
  {
    const SurfaceWindingNumber w(family.Surface, {}, monitor);
    std::mt19937 random(4);
    std::uniform_real_distribution<double> uniform(-80, 80);
    for (int i = 0; i < 40; ++i)
    {
      const Point p = { uniform(random), uniform(random), uniform(random) };
      const Point gradient = w.Gradient(p);
      for (int axis = 0; axis < 3; ++axis)
      {
        if (w.IsClosed())
        {
          EXPECT_EQ(gradient[axis], 0) << family.Name;
          continue;
        }
        const double h = 1e-4;
        Point above = p, below = p;
        above[axis] += h;
        below[axis] -= h;
        double difference = w.At(above) - w.At(below);
        difference -= std::round(difference); // a facet in between
        EXPECT_NEAR(gradient[axis], difference / (2 * h),
          1e-4 * (std::abs(gradient[0]) + std::abs(gradient[1]) + std::abs(gradient[2])) + 1e-9)
          << family.Name;
      }
    }
  }
}

TEST(SurfaceWindingNumber, KnowsNothingOfPointsThatAreNotFiniteAndIsZeroAfar)
{
  Monitor monitor;
  const FacetComplex open = Counted(WithHoles(Ball(16, 64), 1));
  const double infinity = std::numeric_limits<double>::infinity();
  for (int method = 0; method < 4; ++method)
  {
    const SurfaceWindingNumber w(open, { static_cast<WindingNumberMethod>(method) }, monitor);
    const std::vector<Point> points = { { 0, std::nan(""), 0 }, { infinity, 0, 0 }, { 1e300, 0, 0 },
      { 0, -1e20, 0 }, { 0, 1e5, 1e5 }, { 1e28, 1e29, 0 }, { 0, 1e14, -1e14 } };
    const std::vector<double> values = w.At(points, monitor);
    EXPECT_TRUE(std::isnan(values[0]) && std::isnan(values[1]));
    EXPECT_TRUE(std::isnan(w.At(points[0])) && std::isnan(w.At(points[1])));
    EXPECT_EQ(values[2], 0);
    EXPECT_EQ(w.At(points[2]), 0);
    EXPECT_NEAR(values[3], 0, 1e-14);
    EXPECT_NEAR(values[4], SumInQuads(open, points[4]), 1e-6);
    for (std::size_t i = 5; i < points.size(); ++i)
    {
      EXPECT_NEAR(values[i], 0, 1e-14);
      EXPECT_NEAR(w.At(points[i]), 0, 1e-14);
    }
    EXPECT_EQ(w.Gradient(points[0])[0], 0);
  }
}

TEST(SurfaceWindingNumber, DoesNotDependOnScale)
{
  const FacetComplex surface = Families()[1].Surface;
  const std::vector<Point> points = PointsAround(surface, 2, 20);
  for (const WindingNumberMethod method :
    { WindingNumberMethod::Exact, WindingNumberMethod::Hierarchical })
  {
    const std::vector<double> w = Evaluate(surface, points, method);
    for (double factor : { 0x1p-400, 0x1p500, 0x1p1000, 0x1p-1000 })
    {
      FacetComplex scaled = surface;
      std::vector<Point> scaledPoints = points;
      for (std::vector<Point>* list : { &scaled.Points, &scaledPoints })
      {
        for (Point& p : *list)
        {
          p = { p[0] * factor, p[1] * factor, p[2] * factor };
        }
      }
      EXPECT_EQ(Evaluate(scaled, scaledPoints, method), w) << factor;
    }
  }
}

TEST(SurfaceWindingNumber, GivesTheSameBytesForAnyNumberOfThreads)
{
  const FacetComplex surface = Counted(WithHoles(Ball(24, 1024), 1));
  const std::vector<Point> points = PointsAround(surface, 3, 300);
  const WholeTeams teams;
  const int threads = omp_get_max_threads();
  for (int method = 0; method < 4; ++method)
  {
    omp_set_num_threads(1);
    const std::vector<double> w =
      Evaluate(surface, points, static_cast<WindingNumberMethod>(method));
    for (int n : { 2, 8 })
    {
      omp_set_num_threads(n);
      const std::vector<double> again =
        Evaluate(surface, points, static_cast<WindingNumberMethod>(method));
      EXPECT_EQ(std::memcmp(w.data(), again.data(), 8 * w.size()), 0)
        << n << " threads, method " << method;
    }
  }
  omp_set_num_threads(threads);
}

TEST(SurfaceWindingNumber, StopsWhenAskedTo)
{
  class Stopping : public Monitor
  {
  public:
    bool Continue(const char*, double) override { return false; }
  };
  Monitor monitor;
  Stopping stopping;
  const FacetComplex box = Counted(testmeshes::Box({ 0, 0, 0 }, { 1, 1, 1 }));
  const SurfaceWindingNumber w(box, {}, monitor);
  try
  {
    w.At(std::vector<Point>{ { 0, 0, 0 } }, stopping);
    ADD_FAILURE();
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::Stopped);
  }
}

TEST(SurfaceWindingNumber, IsDefinedOnAFlatFanWithAGapOfRounding)
{
  // A disk in a plane, of which the first and the last point should be one.
  const int corners = 36;
  FacetComplex fan;
  fan.Points = { { 0, 0, 0 } };
  for (int i = 0; i <= corners; ++i)
  {
    const double angle = 2 * 3.14159265358979323846 * i / corners;
    fan.Points.push_back({ 0.1 * std::cos(angle), 0.1 * std::sin(angle), 0 });
  }
  for (int i = 1; i <= corners; ++i)
  {
    fan.Facets.push_back({ { 0, i, i + 1 } });
    fan.Multiplicity.push_back(1);
  }
  fan.NumberOfConstraints = fan.NumberOfFacets();
  Monitor monitor;
  const SurfaceWindingNumber w(fan, {}, monitor);
  EXPECT_NE(fan.Points[1], fan.Points.back());
  for (int i = 1; i <= corners; ++i)
  {
    const Point& p = fan.Points[static_cast<std::size_t>(i)];
    EXPECT_NEAR(w.At(Point{ p[0] / 2, p[1] / 2, 0 }), 0, 1e-15) << i; // the disk is open
    const Point below = { p[0] / 2, p[1] / 2, -1e-9 };
    EXPECT_NEAR(w.At(below), 0.5, 1e-7) << i;
  }
}
} // namespace
