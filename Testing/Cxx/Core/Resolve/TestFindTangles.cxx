// SPDX-License-Identifier: GPL-3.0-or-later
#include "Resolve/FindTangles.h"

#include "Common/Vectors.h"
#include "Resolve/FindIntersections.h"
#include "Resolve/ResolveSelfIntersections.h"
#include "Support/TestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace insideout;
using namespace testmeshes;

namespace
{
constexpr double Pi = 3.14159265358979323846;

/** 80 facets that all cross each other, in 76,000 points. */
constexpr Id Sides = 40;

/**
 * A closed surface whose sides all pass through the origin, but for the rounding of coordinates: a
 * polygon, its image through the origin, 0.6 times as large and turned by half a side, and strips
 * between them.
 */
TriangleSoup DoubleCone(Id sides)
{
  const auto rounded = [](double x) { return std::round(x * 1e6) / 1e6; };
  TriangleSoup soup;
  for (const double scale : { 1.0, -0.6 })
  {
    for (Id i = 0; i < sides; ++i)
    {
      const double turn = static_cast<double>(i) + (scale < 0 ? 0.5 : 0);
      const double angle = 2 * Pi * turn / static_cast<double>(sides);
      soup.Points.push_back(
        { rounded(scale * std::cos(angle)), rounded(scale * std::sin(angle)), scale });
    }
  }
  soup.Points.push_back({ 0, 0, 1 });
  soup.Points.push_back({ 0, 0, -0.6 });
  for (Id i = 0; i < sides; ++i)
  {
    const Id j = (i + 1) % sides;
    soup.Triangles.push_back({ i, j, 2 * sides });
    soup.Triangles.push_back({ j, i, sides + i });
    soup.Triangles.push_back({ j, sides + i, sides + j });
    soup.Triangles.push_back({ sides + j, sides + i, 2 * sides + 1 });
  }
  return soup;
}

/** Needles of square cross section from one side of the unit sphere to the other. */
TriangleSoup Needles(int count, double width)
{
  TriangleSoup soup;
  for (int i = 0; i < count; ++i)
  {
    const double z = -1 + (2 * i + 1.0) / (2 * count);
    const double angle = 2.4 * i;
    const double r = std::sqrt(1 - z * z);
    const Point along = { r * std::cos(angle), r * std::sin(angle), z };
    const Point u = { -std::sin(angle), std::cos(angle), 0 };
    const Point v = Cross(along, u);
    TriangleSoup needle = Box({ -1, -width / 2, -width / 2 }, { 1, width / 2, width / 2 });
    for (Point& p : needle.Points)
    {
      const Point q = p;
      for (int k = 0; k < 3; ++k)
      {
        p[k] = q[0] * along[k] + q[1] * u[k] + q[2] * v[k];
      }
    }
    soup = Join(soup, needle);
  }
  return soup;
}

std::vector<Tangle> TanglesOf(const TriangleSoup& soup)
{
  Monitor monitor;
  const FacetComplex surface = ToComplex(soup);
  return FindTangles({ surface.Points, surface.Facets },
    FindIntersections(surface.Points, surface.Facets, monitor), monitor, { "", 0, 0 });
}

Resolution Resolve(const TriangleSoup& soup)
{
  Monitor monitor;
  return ResolveSelfIntersections(ToComplex(soup), monitor);
}
} // namespace

TEST(FindTangles, FindsWhereRoundedSidesOfAConeMeet)
{
  const std::vector<Tangle> tangles = TanglesOf(DoubleCone(Sides));
  ASSERT_EQ(tangles.size(), 1U);
  EXPECT_EQ(tangles[0].Facets.size(), 2U * Sides);
  EXPECT_EQ(tangles[0].Edges.size(), 2U * Sides);
  EXPECT_LT(Length(tangles[0].Center), 1e-5);
  EXPECT_LT(tangles[0].Distance, 0.04);
}

TEST(FindTangles, FindsSeveral)
{
  TriangleSoup far = DoubleCone(Sides);
  for (Point& p : far.Points)
  {
    p[0] += 10;
  }
  const std::vector<Tangle> tangles = TanglesOf(Join(DoubleCone(Sides), far));
  ASSERT_EQ(tangles.size(), 2U);
  EXPECT_NEAR(tangles[0].Center[0], 0, 1e-4);
  EXPECT_NEAR(tangles[1].Center[0], 10, 1e-4);
}

TEST(FindTangles, LeavesFewCrossingsToBeCut)
{
  EXPECT_TRUE(TanglesOf(DoubleCone(30)).empty());
}

/** These have a thickness, which would be pinched off. */
TEST(FindTangles, LeavesNeedlesThatCrossToBeCut)
{
  const TriangleSoup needles = Needles(40, 0.01);
  EXPECT_TRUE(TanglesOf(needles).empty());
}

TEST(FindTangles, LeavesFacetsThatMeetEverywhereToBeCut)
{
  EXPECT_TRUE(TanglesOf(RandomSoup(1, 400)).empty());
}

/** Cut, this surface has 450,000 pieces. */
TEST(FindTangles, JoinsThemInAPointInsteadOfCutting)
{
  const TriangleSoup soup = DoubleCone(Sides);
  const Resolution resolution = Resolve(soup);
  const FacetComplex& surface = resolution.Surface;
  EXPECT_EQ(surface.NumberOfConstraints, surface.NumberOfFacets());
  EXPECT_LT(surface.NumberOfFacets(), 2 * static_cast<Id>(soup.Triangles.size()));
  EXPECT_EQ(resolution.Warnings.size(), 1U);
  Monitor monitor;
  EXPECT_TRUE(FindIntersections(surface.Points, surface.Facets, monitor).empty());
}

TEST(FindTangles, JoinedTanglesStayClosed)
{
  const FacetComplex surface = Resolve(DoubleCone(Sides)).Surface;
  std::map<Edge, int> counts;
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    const Triangle& t = surface.Facets[f];
    for (int k = 0; k < 3; ++k)
    {
      const Id p = t[k];
      const Id q = t[(k + 1) % 3];
      counts[EdgeBetween(p, q)] += (p < q ? 1 : -1) * surface.Multiplicity[f];
    }
  }
  for (const auto& edge : counts)
  {
    EXPECT_EQ(edge.second, 0) << edge.first[0] << ", " << edge.first[1];
  }
}

TEST(FindTangles, JoinedTanglesKeepTheVolume)
{
  const FacetComplex surface = Resolve(DoubleCone(Sides)).Surface;
  double volume = 0;
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    const Triangle& t = surface.Facets[f];
    volume += surface.Multiplicity[f] *
      Determinant(surface.Points[t[0]], surface.Points[t[1]], surface.Points[t[2]]) / 6;
  }
  const double base = Sides * std::sin(2 * Pi / Sides) / 2;
  EXPECT_NEAR(volume, base / 3 * (1 + 0.6 * 0.6 * 0.6), 1e-5);
}

TEST(FindTangles, JoinsThemInAPointThatIsThere)
{
  TriangleSoup soup = DoubleCone(Sides);
  const Point center = TanglesOf(soup).at(0).Center;
  const Id there = static_cast<Id>(soup.Points.size());
  soup.Points.push_back(center);
  const FacetComplex surface = Resolve(soup).Surface;
  EXPECT_EQ(std::count(surface.Points.begin(), surface.Points.end(), center), 1);
  EXPECT_EQ(std::count_if(surface.Facets.begin(), surface.Facets.end(),
              [&](const Triangle& t) { return std::count(t.begin(), t.end(), there) == 1; }),
    2 * Sides);
}

TEST(FindTangles, HaveFiniteCentersWhereAreasOverflow)
{
  for (const int exponent : { 511, 512 })
  {
    TriangleSoup soup = DoubleCone(Sides);
    for (Point& p : soup.Points)
    {
      p = { std::ldexp(p[0], exponent), std::ldexp(p[1], exponent), std::ldexp(p[2], exponent) };
    }
    for (const Tangle& tangle : TanglesOf(soup))
    {
      EXPECT_TRUE(IsFinite(tangle.Center)) << exponent;
      EXPECT_LT(Length(tangle.Center), std::ldexp(1, exponent)) << exponent;
    }
  }
}

TEST(FindTangles, CanBeStopped)
{
  class Stopper : public Monitor
  {
    bool Continue(const char*, double) override { return false; }
  };
  Monitor monitor;
  Stopper stopper;
  const FacetComplex surface = ToComplex(DoubleCone(Sides));
  const auto pairs = FindIntersections(surface.Points, surface.Facets, monitor);
  EXPECT_THROW(
    FindTangles({ surface.Points, surface.Facets }, pairs, stopper, { "", 0, 0 }), Error);
}
