// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/SolidAngle.h"

#include "Support/BruteForceWindingNumber.h"
#include "WindingNumber/Pi.h"
#include "WindingNumber/SolidAngleProduct.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{
using namespace insideout;

/** Points whose coordinates are quarters, or so near to one that it takes many digits to tell. */
class NearlyMeetingPoints
{
public:
  NearlyMeetingPoints(unsigned seed, int exponents)
    : Random(seed)
    , Exponents(exponents)
  {
  }

  int Below(int n) { return static_cast<int>(this->Random() % static_cast<unsigned>(n)); }

  Point Next() { return { this->Coordinate(), this->Coordinate(), this->Coordinate() }; }

  /** The barycenter of a point taken four times, or of points near a triangle's edge or corner. */
  Site NextSite(const std::array<Point, 3>& triangle)
  {
    Site site = SiteAt(this->Next());
    if (this->Below(2) == 0)
    {
      const Point& corner = triangle[static_cast<std::size_t>(this->Below(3))];
      site.Corners = { { corner, triangle[0], corner, corner } };
      site.Corners[3][static_cast<std::size_t>(this->Below(3))] += this->Small();
    }
    return site;
  }

private:
  double Small() { return std::ldexp(this->Below(5) - 2, -3 - this->Below(this->Exponents)); }

  double Coordinate()
  {
    const double quarters = (this->Below(5) - 2) / 4.0;
    const int kind = this->Below(3);
    return kind == 0 ? quarters : kind == 1 ? this->Small() : quarters + this->Small();
  }

  std::mt19937 Random;
  int Exponents;
};

bool IsPoint(const Site& site)
{
  return site.Corners[0] == site.Corners[1] && site.Corners[0] == site.Corners[2] &&
    site.Corners[0] == site.Corners[3];
}

TEST(HalfSolidAngle, IsRightForAnOctantAndNextToAnEdge)
{
  const auto cell = [](const Point& centre, double size) -> Site
  {
    const auto corner = [&](double x, double y, double z) -> Point {
      return { centre[0] + x * size, centre[1] + y * size, centre[2] + z * size };
    };
    return { { { corner(1, 1, 1), corner(-1, -1, 1), corner(-1, 1, -1), corner(1, -1, -1) } },
      BarycentreWeights };
  };
  const double pi = std::acos(-1);
  const std::array<Point, 3> octant = { { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } };
  EXPECT_NEAR(std::arg(HalfSolidAngle(octant, cell({ 0, 0, 0 }, 1))), pi / 4, 1e-15);
  const std::array<Point, 3> turned = { { { 1, 0, 0 }, { 0, 0, 1 }, { 0, 1, 0 } } };
  EXPECT_NEAR(std::arg(HalfSolidAngle(turned, cell({ 0, 0, 0 }, 1))), -pi / 4, 1e-15);

  // Below an edge by h, the triangle is seen as half of a half space, however small h is.
  const std::array<Point, 3> flat = { { { -1, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } } };
  for (double h : { 1e-20, 1e-30, 1e-150, 1e-300 })
  {
    EXPECT_NEAR(std::arg(HalfSolidAngle(flat, cell({ 0, 0, -h }, h))), pi / 2, 1e-15) << h;
    EXPECT_NEAR(std::arg(HalfSolidAngle(flat, cell({ 0, h, -h }, h / 4))), 3 * pi / 4, 1e-15) << h;
    EXPECT_NEAR(std::arg(HalfSolidAngle(flat, cell({ 0, -h, -h }, h / 4))), pi / 4, 1e-15) << h;
    EXPECT_NEAR(std::arg(HalfSolidAngle(flat, cell({ 0, -h, h }, h / 4))), -pi / 4, 1e-15) << h;
  }
  EXPECT_EQ(HalfSolidAngle(flat, cell({ 0, 0.25, 0 }, 1)), 1.0);
  EXPECT_EQ(HalfSolidAngle(flat, cell({ 0, 0, 0 }, 1)), 1.0);
  EXPECT_EQ(HalfSolidAngle(flat, cell({ 5, 1, 0 }, 1)), 1.0);
  EXPECT_GT(HalfSolidAngle(flat, cell({ 0, 0.25, -1e-300 }, 1e-300)).imag(), 0);
  EXPECT_LT(HalfSolidAngle(flat, cell({ 0, 0.25, 1e-300 }, 1e-300)).imag(), 0);
}

TEST(HalfSolidAngle, KnowsTheSideHoweverNearASlantedPlane)
{
  const std::array<Point, 3> octant = { { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } };
  const double pi = std::acos(-1);
  for (const int exponent : { -50, -60, -80, -300, -1000 })
  {
    for (const double sign : { -1.0, 1.0 })
    {
      // Barycenters off the plane by t / 4, next to nothing or lost where they are rounded.
      const double t = std::ldexp(sign, exponent);
      const Site inside = {
        { { { t, 0.25, 0.75 }, { 0.5, 0.25, 0.25 }, { 0.25, 0.25, 0.5 }, { 0.25, 0.25, 0.5 } } },
        BarycentreWeights
      };
      EXPECT_NEAR(std::arg(HalfSolidAngle(octant, inside)), -sign * pi, 1e-13) << t;
      const Site outside = {
        { { { t, 0.5, 0.5 }, { -2, 0.5, 2.5 }, { 0, 0.5, 0.5 }, { 0, 0.5, 0.5 } } },
        BarycentreWeights
      };
      const std::complex<double> z = HalfSolidAngle(octant, outside);
      EXPECT_NEAR(std::arg(z), 0, 1e-13) << t;
      EXPECT_LT(sign * z.imag(), 0) << t;
    }
  }
}

TEST(HalfSolidAngle, EqualsManyDigitsHoweverNearACornerOrAnEdge)
{
  const double pi = std::acos(-1);
  int inPlane = 0;
  int points = 0;
  for (const int exponents : { 60, 300, 1060 })
  {
    NearlyMeetingPoints random(1, exponents);
    for (int i = 0; i < 2000; ++i)
    {
      const std::array<Point, 3> t = { random.Next(), random.Next(), random.Next() };
      const Site site = random.NextSite(t);
      const double expected = static_cast<double>(testmeshes::HalfSolidAngleInLong(site, t));
      const std::complex<double> z = HalfSolidAngle(t, site);
      EXPECT_NEAR(std::arg(z), expected, 1e-13) << exponents << " " << i;
      EXPECT_NEAR(std::abs(z), 1, 1e-13) << exponents << " " << i;
      EXPECT_NEAR(std::abs(HalfSolidAngle({ t[1], t[2], t[0] }, site) - z), 0, 1e-13)
        << exponents << " " << i;
      EXPECT_NEAR(std::abs(HalfSolidAngle({ t[0], t[2], t[1] }, site) - std::conj(z)), 0, 1e-13)
        << exponents << " " << i;
      inPlane += expected == 0;
      if (IsPoint(site))
      {
        EXPECT_NEAR(WindingNumberOfTriangle(t, site.Corners[0]), expected / (2 * pi), 1e-13)
          << exponents << " " << i;
        ++points;
      }
    }
  }
  EXPECT_LT(inPlane, 2000);
  EXPECT_GT(points, 2000);
}

TEST(WindingNumberOfTriangle, KeepsItsDigitsWhereProductsUnderflow)
{
  const double pi = std::acos(-1);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (const int exponent : { 0, -170, -180, -350, -360, -530, -540 })
  {
    const auto next = [&](double factor) -> Point
    {
      return { std::ldexp(factor * coordinate(random), exponent),
        std::ldexp(factor * coordinate(random), exponent),
        std::ldexp(factor * coordinate(random), exponent) };
    };
    for (int i = 0; i < 200; ++i)
    {
      const std::array<Point, 3> t = { next(1), next(1), next(1) };
      // Anywhere, or beside the middle of an edge.
      Point p = next(1);
      if (i % 2 == 0)
      {
        const Point off = next(1e-6);
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          p[axis] = t[0][axis] / 2 + t[1][axis] / 2 + off[axis];
        }
      }
      const double expected =
        static_cast<double>(testmeshes::HalfSolidAngleInLong(SiteAt(p), t)) / (2 * pi);
      EXPECT_NEAR(WindingNumberOfTriangle(t, p), expected, 1e-13) << exponent << " " << i;
    }
  }
}

TEST(SolidAngleProduct, SideOfANeedleIsDecidedAtItsShortSide)
{
  const std::vector<Point> points = { { 0, 0, 0 }, { 0.9, 0, 0 }, { 0.9, 0.001, 0 } };
  const Triangle corners = FromBluntCorner(points, { 0, 1, 2 });
  EXPECT_NE(corners[0], 0);
  SummedFacet facet;
  facet.Corners = corners;
  facet.Local = { 0, 1, 2 };
  std::vector<Point> turned;
  for (const Id corner : corners)
  {
    turned.push_back(points[corner]);
  }
  SetGeometry(facet, turned[0], turned[1], turned[2]);
  SiteBlock block = {};
  for (int lane = 0; lane < Lanes; ++lane)
  {
    block.High[0][lane] = 0.9;
    block.High[1][lane] = 0.0003;
    block.High[2][lane] = 0.0001 * (lane + 1);
  }
  UnitVectors vectors[3];
  ComputeUnitVectors(turned.data(), 3, block, vectors);
  Products products = {};
  std::fill(products.Real, products.Real + Lanes, 1.0);
  double undecided[Lanes] = {};
  MultiplyByFacets(&facet, &facet + 1, vectors, products, undecided);
  for (int lane = 0; lane < Lanes; ++lane)
  {
    EXPECT_EQ(undecided[lane], 0);
    const Point site = { block.High[0][lane], block.High[1][lane], block.High[2][lane] };
    const std::array<Point, 3> triangle = { points[0], points[1], points[2] };
    const double w = std::arg(HalfSolidAngle(triangle, SiteAt(site))) / (2 * Pi);
    EXPECT_NEAR(WindingNumber(products, lane), w, 1e-15);
  }
}
} // namespace
