// SPDX-License-Identifier: GPL-3.0-or-later
#include "Distance/SurfaceDistance.h"

#include "Common/NearestPoint.h"
#include "Common/Vectors.h"
#include "Support/ReadTriangles.h"
#include "Support/TestMeshes.h"
#include "Validate/CountedChain.h"

#include <gtest/gtest.h>
#include <quadmath.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

namespace
{
using namespace insideout;
using Quad = Vector<__float128>;

Quad QuadOf(const Point& p)
{
  return { p[0], p[1], p[2] };
}

__float128 SquaredDistanceOfSegment(const Quad& a, const Quad& b, const Quad& p)
{
  const Quad along = Difference(b, a);
  const Quad to = Difference(p, a);
  const __float128 length = Dot(along, along);
  __float128 t = length > 0 ? Dot(to, along) / length : 0;
  t = t < 0 ? 0 : t > 1 ? 1 : t;
  const Quad d = { to[0] - t * along[0], to[1] - t * along[1], to[2] - t * along[2] };
  return Dot(d, d);
}

/** In twice the digits: to the plane where the foot is within, else to the sides. */
double DistanceInQuads(const FacetComplex& surface, Id facet, const Point& place)
{
  std::array<Quad, 3> c;
  for (int k = 0; k < 3; ++k)
  {
    c[k] = QuadOf(surface.Points[surface.Facets[facet][k]]);
  }
  const Quad p = QuadOf(place);
  const Quad normal = Cross(Difference(c[1], c[0]), Difference(c[2], c[0]));
  __float128 least = std::numeric_limits<double>::infinity();
  bool isWithin = true;
  for (int k = 0; k < 3; ++k)
  {
    const Quad& a = c[k];
    const Quad& b = c[(k + 1) % 3];
    const __float128 side = Dot(Cross(Difference(b, a), Difference(p, a)), normal);
    isWithin = isWithin && side >= 0;
    const __float128 squared = SquaredDistanceOfSegment(a, b, p);
    least = squared < least ? squared : least;
  }
  const __float128 height = Dot(normal, Difference(p, c[0]));
  return static_cast<double>(isWithin ? fabsq(height) / sqrtq(Dot(normal, normal)) : sqrtq(least));
}

double LeastInQuads(const FacetComplex& surface, const Point& place)
{
  double least = std::numeric_limits<double>::infinity();
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    least = std::min(least, DistanceInQuads(surface, f, place));
  }
  return least;
}

/** Whole coordinates; and the same flattened to needles. */
std::vector<FacetComplex> Surfaces()
{
  Monitor monitor;
  std::vector<FacetComplex> surfaces;
  for (const double flat : { 1.0, 1e-3, 1e-5 })
  {
    TriangleSoup soup = testmeshes::GridSoup(3, 80, 16);
    for (Point& p : soup.Points)
    {
      p[0] *= flat;
      p[1] *= flat;
    }
    surfaces.push_back(CountFacets(soup, {}, monitor).Surface);
  }
  return surfaces;
}

std::vector<Point> Places(const FacetComplex& surface)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-8, 24);
  std::vector<Point> places(surface.Points.begin(), surface.Points.begin() + 20);
  for (int i = 0; i < 150; ++i)
  {
    places.push_back({ uniform(random), uniform(random), uniform(random) });
    const Triangle& t = surface.Facets[random() % surface.Facets.size()];
    Point inside;
    for (int axis = 0; axis < 3; ++axis)
    {
      inside[axis] = 0.25 * surface.Points[t[0]][axis] + 0.5 * surface.Points[t[1]][axis] +
        0.25 * surface.Points[t[2]][axis];
    }
    places.push_back(inside);
  }
  return places;
}

TEST(SurfaceDistance, IsThatInTwiceTheDigits)
{
  for (const FacetComplex& surface : Surfaces())
  {
    const SurfaceDistance distance(surface.Points, surface.Facets);
    for (const Point& place : Places(surface))
    {
      const SurfaceDistance::Nearest nearest = distance.At(place);
      EXPECT_NEAR(nearest.Distance, LeastInQuads(surface, place), 1e-13);
      EXPECT_NEAR(nearest.Distance, Distance(nearest.Place, place), 1e-13);
      EXPECT_NEAR(DistanceInQuads(surface, nearest.Facet, nearest.Place), 0, 1e-13);
    }
  }
}

/** Whose normal doubles do not know. */
TEST(SurfaceDistance, FindsTheFootOnANeedle)
{
  Monitor monitor;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int round = 0; round < 50; ++round)
  {
    TriangleSoup soup;
    const Point a = { uniform(random), uniform(random), uniform(random) };
    const Point b = { uniform(random), uniform(random), uniform(random) };
    Point c;
    for (int axis = 0; axis < 3; ++axis)
    {
      c[axis] = (a[axis] + b[axis]) / 2 + 1e-5 * uniform(random);
    }
    soup.Points = { a, b, c };
    soup.Triangles = { { { 0, 1, 2 } } };
    const FacetComplex surface = CountFacets(soup, {}, monitor).Surface;
    const Quad normal = Cross(Difference(QuadOf(b), QuadOf(a)), Difference(QuadOf(c), QuadOf(a)));
    Point place;
    for (int axis = 0; axis < 3; ++axis)
    {
      place[axis] = (a[axis] + b[axis] + 2 * c[axis]) / 4 +
        static_cast<double>(3 * normal[axis] / sqrtq(Dot(normal, normal)));
    }
    const SurfaceDistance::Nearest nearest =
      SurfaceDistance(surface.Points, surface.Facets).At(place);
    EXPECT_NEAR(nearest.Distance, DistanceInQuads(surface, 0, place), 1e-13);
    EXPECT_NEAR(DistanceInQuads(surface, 0, nearest.Place), 0, 1e-13);
  }
}

TEST(SurfaceDistance, IsTheSameForOnePlaceAndForMany)
{
  Monitor monitor;
  for (const FacetComplex& surface : Surfaces())
  {
    const SurfaceDistance distance(surface.Points, surface.Facets);
    const std::vector<Point> places = Places(surface);
    const auto many = distance.At(places, monitor, { "", 0, 1 });
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      const SurfaceDistance::Nearest one = distance.At(places[i]);
      EXPECT_EQ(many[i].Distance, one.Distance);
      EXPECT_EQ(many[i].Place, one.Place);
      EXPECT_EQ(many[i].Facet, one.Facet);
    }
  }
}

/** Enough places for searches of several at a time: in rows, scattered, on facets, far away and not
 * finite. */
TEST(SurfaceDistance, IsTheSameForOnePlaceAndForVeryMany)
{
  Monitor monitor;
  const double infinity = std::numeric_limits<double>::infinity();
  for (const FacetComplex& surface : Surfaces())
  {
    const SurfaceDistance distance(surface.Points, surface.Facets);
    std::vector<Point> places = Places(surface);
    for (int i = 0; i < 5000; ++i)
    {
      places.push_back({ i % 20 + 0.5, i / 20 % 20 - 1.0, i / 400 * 2.0 });
    }
    for (std::size_t i = 0; i < places.size(); i += 111)
    {
      places[i] = { i % 2 ? infinity : 1e300, 0, 0 };
    }
    const auto many = distance.At(places, monitor, { "", 0, 1 });
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      const SurfaceDistance::Nearest one = distance.At(places[i]);
      ASSERT_EQ(many[i].Facet, one.Facet);
      if (one.Facet != None)
      {
        ASSERT_EQ(many[i].Distance, one.Distance);
        ASSERT_EQ(many[i].Place, one.Place);
      }
    }
  }
}

/** Rounding makes a place lie on facets whose boxes it is not in. */
TEST(SurfaceDistance, TellsTheLowestOfFacetsThatAreAsNear)
{
  Monitor monitor;
  for (const char* name : { "corners-nearly-one-0", "corners-nearly-one-7", "nearly-in-one-plane" })
  {
    const TriangleSoup soup =
      testmeshes::ReadTriangles(INSIDEOUT_CORPUS "/" + std::string(name) + ".off");
    const FacetComplex surface = CountFacets(soup, {}, monitor).Surface;
    const SurfaceDistance distance(surface.Points, surface.Facets);
    std::vector<Point> places;
    while (places.size() < 2000)
    {
      places.insert(places.end(), surface.Points.begin(), surface.Points.end());
    }
    const auto many = distance.At(places, monitor, { "", 0, 1 });
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      SurfaceDistance::Nearest best = { 0, {}, None, std::numeric_limits<double>::infinity() };
      for (Id f = 0; f < surface.NumberOfFacets(); ++f)
      {
        const Point there = NearestPointOf(CornersOf(surface.Points, surface.Facets[f]), places[i]);
        const Point d = Difference(there, places[i]);
        const SurfaceDistance::Nearest found = { 0, there, f, Dot(d, d) };
        best = found.IsNearerThan(best) ? found : best;
      }
      ASSERT_EQ(distance.At(places[i]).Facet, best.Facet) << name << " " << i;
      ASSERT_EQ(many[i].Facet, best.Facet) << name << " " << i;
    }
  }
}

TEST(SurfaceDistance, IsThatOfAnySize)
{
  const FacetComplex unit = Surfaces().front();
  for (const int exponent : { -900, 900 })
  {
    FacetComplex surface = unit;
    std::vector<Point> places = Places(unit);
    const std::vector<Point> original = places;
    for (std::vector<Point>* points : { &surface.Points, &places })
    {
      for (Point& p : *points)
      {
        p = { std::ldexp(p[0], exponent), std::ldexp(p[1], exponent), std::ldexp(p[2], exponent) };
      }
    }
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      EXPECT_EQ(SurfaceDistance(surface.Points, surface.Facets).At(places[i]).Distance,
        std::ldexp(SurfaceDistance(unit.Points, unit.Facets).At(original[i]).Distance, exponent));
      i += 20;
    }
  }
}

TEST(SurfaceDistance, IsKnownAfarAndNotWherePlacesAreNotFinite)
{
  Monitor monitor;
  const FacetComplex surface = Surfaces().front();
  const SurfaceDistance distance(surface.Points, surface.Facets);
  EXPECT_NEAR(distance.At({ 1e250, 0, 0 }).Distance / 1e250, 1, 1e-15);
  EXPECT_NEAR(distance.At({ 1e15, 0, 0 }).Distance / 1e15, 1, 1e-13);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto both = distance.At({ { 0, nan, 0 }, { 0, 0, 0 } }, monitor, { "", 0, 1 });
  EXPECT_TRUE(std::isnan(both[0].Distance));
  EXPECT_EQ(both[0].Facet, None);
  EXPECT_FALSE(std::isnan(both[1].Distance));
}
} // namespace
