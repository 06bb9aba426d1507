// SPDX-License-Identifier: GPL-3.0-or-later
#include "Quality/CellQuality.h"

#include "Common/PointPredicates.h"
#include "Common/Vectors.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace
{
using namespace insideout;

using Corners = std::array<Point, 4>;
using Real = boost::multiprecision::cpp_bin_float_100;
using RealVector = std::array<Real, 3>;

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double Right = 90;
constexpr double Corner = 54.735610317245346; // acos(1 / sqrt(3))

RealVector RealEdge(const Corners& corners, int from, int to)
{
  const Point& a = corners[from];
  const Point& b = corners[to];
  return { Real(b[0]) - a[0], Real(b[1]) - a[1], Real(b[2]) - a[2] };
}

Real Squared(const RealVector& a)
{
  return Dot(a, a);
}

/** The angle at an edge between what the other two corners' directions have across it: by half its
 * tangent. */
double ExpectedAngle(const Corners& corners, int edge)
{
  const auto [i, j] = TetrahedronEdges[edge];
  const RealVector along = RealEdge(corners, i, j);
  std::array<RealVector, 2> sides;
  int side = 0;
  for (int k = 0; k < 4; ++k)
  {
    if (k != i && k != j)
    {
      RealVector across = RealEdge(corners, i, k);
      const Real part = Dot(across, along) / Squared(along);
      for (int x = 0; x < 3; ++x)
      {
        across[x] -= part * along[x];
      }
      const Real length = sqrt(Squared(across));
      for (Real& x : across)
      {
        x /= length;
      }
      sides[side++] = across;
    }
  }
  RealVector sum;
  for (int x = 0; x < 3; ++x)
  {
    sum[x] = sides[0][x] + sides[1][x];
  }
  const Real tangent = sqrt(Squared(Difference(sides[0], sides[1]))) / sqrt(Squared(sum));
  return static_cast<double>(2 * atan(tangent) * 180 / boost::math::constants::pi<Real>());
}

/** Radius-edge ratio and mean ratio. */
std::array<double, 2> ExpectedRatios(const Corners& corners)
{
  Real squares = 0;
  Real shortest = Squared(RealEdge(corners, 0, 1));
  for (const auto& [i, j] : TetrahedronEdges)
  {
    const Real square = Squared(RealEdge(corners, i, j));
    squares += square;
    shortest = std::min(shortest, square);
  }
  // The radius by products of opposite edges (Crelle).
  const auto product = [&](int i, int j, int k, int l)
  { return Real(sqrt(Squared(RealEdge(corners, i, j)) * Squared(RealEdge(corners, k, l)))); };
  const Real p = product(0, 1, 2, 3);
  const Real q = product(0, 2, 1, 3);
  const Real r = product(0, 3, 1, 2);
  const Real volume =
    abs(Determinant(RealEdge(corners, 0, 1), RealEdge(corners, 0, 2), RealEdge(corners, 0, 3)));
  const Real radius = sqrt((p + q + r) * (p + q - r) * (p - q + r) * (q + r - p)) / (4 * volume);
  return { static_cast<double>(radius / sqrt(shortest)),
    static_cast<double>(12 * pow(cbrt(volume / 2), 2) / squares) };
}

/** The same corners in another place and direction, so that no coordinate is what is thin. */
Corners Turned(const Corners& corners)
{
  // Columns of a rotation, about enough; what counts is where the points are after it.
  constexpr std::array<Point, 3> axes = { { { { 0.36, 0.48, -0.8 } }, { { -0.8, 0.6, 0 } },
    { { 0.48, 0.64, 0.6 } } } };
  Corners turned;
  for (int k = 0; k < 4; ++k)
  {
    for (int i = 0; i < 3; ++i)
    {
      turned[k][i] =
        1 + axes[i][0] * corners[k][0] + axes[i][1] * corners[k][1] + axes[i][2] * corners[k][2];
    }
  }
  return turned;
}

Corners RandomCorners(std::mt19937& random)
{
  std::uniform_real_distribution<double> uniform(-1, 1);
  Corners corners;
  for (Point& p : corners)
  {
    for (double& x : p)
    {
      x = uniform(random);
    }
  }
  return corners;
}

void ExpectSame(const CellQuality& found, const CellQuality& expected)
{
  EXPECT_EQ(found.DihedralAngles, expected.DihedralAngles);
  EXPECT_EQ(found.RadiusEdgeRatio, expected.RadiusEdgeRatio);
  EXPECT_EQ(found.MeanRatio, expected.MeanRatio);
}
} // namespace

TEST(CellQuality, OfARegularCellIsTheBest)
{
  const CellQuality found =
    QualityOfCell({ { { 1, 1, 1 }, { -1, 1, -1 }, { 1, -1, -1 }, { -1, -1, 1 } } });
  for (const double angle : found.DihedralAngles)
  {
    EXPECT_NEAR(angle, std::acos(1.0 / 3) * 180 / M_PI, 1e-13);
  }
  EXPECT_NEAR(found.RadiusEdgeRatio, std::sqrt(6.0) / 4, 1e-15);
  EXPECT_NEAR(found.MeanRatio, 1, 1e-15);
}

TEST(CellQuality, OfACubesCornerIsThatOfItsClosedForm)
{
  const CellQuality found =
    QualityOfCell({ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } });
  const std::array<double, 6> expected = { { Right, Corner, Right, Right, Corner, Corner } };
  for (int e = 0; e < 6; ++e)
  {
    EXPECT_NEAR(found.DihedralAngles[e], expected[e], 1e-13) << "edge " << e;
  }
  EXPECT_NEAR(found.RadiusEdgeRatio, std::sqrt(3.0) / 2, 1e-15);
  EXPECT_NEAR(found.MeanRatio, 12 * std::pow(0.5, 2.0 / 3) / 9, 1e-15);
}

TEST(CellQuality, OfASliverIsThatOfItsClosedFormHoweverThin)
{
  // Over a square's two diagonals, one lifted by h.
  for (double h = 1; h > 1e-150; h /= 1024)
  {
    const CellQuality found =
      QualityOfCell({ { { 1, 0, 0 }, { 0, 1, h }, { -1, 0, 0 }, { 0, -1, h } } });
    const auto degrees = [](double tangent) { return std::atan(tangent) * 180 / M_PI; };
    EXPECT_NEAR(found.MaxDihedralAngle(), 180 - 2 * degrees(h), 1e-12);
    const double atSides = degrees(h * std::sqrt(2 + h * h));
    EXPECT_NEAR(found.MinDihedralAngle(), atSides, 1e-14 * atSides) << h;
    EXPECT_NEAR(found.RadiusEdgeRatio, std::sqrt((1 + h * h / 4) / (2 + h * h)), 1e-14) << h;
    EXPECT_GT(found.MeanRatio, 0);
  }
}

TEST(CellQuality, IsThatOfAHundredDigits)
{
  std::mt19937 random(5);
  for (const double height : { 1.0, 1e-4, 1e-8, 1e-12, 1e-16, 1e-19 })
  {
    for (int k = 0; k < 60; ++k)
    {
      Corners corners = RandomCorners(random);
      for (Point& p : corners)
      {
        p[2] *= height;
        p[1] *= k % 2 == 0 ? 1 : height; // needles, too
      }
      corners = k % 3 == 0 ? corners : Turned(corners);
      if (Orient3D(corners[0], corners[1], corners[2], corners[3]) == 0)
      {
        continue; // by rounding
      }
      const CellQuality found = QualityOfCell(corners);
      for (int e = 0; e < 6; ++e)
      {
        const double expected = ExpectedAngle(corners, e);
        EXPECT_NEAR(
          found.DihedralAngles[e], expected, 1e-8 * std::min(expected, 180 - expected) + 1e-13)
          << "height " << height << ", cell " << k << ", edge " << e;
      }
      const auto [radiusEdge, mean] = ExpectedRatios(corners);
      EXPECT_NEAR(found.RadiusEdgeRatio, radiusEdge, 1e-8 * radiusEdge) << height << ", " << k;
      EXPECT_NEAR(std::abs(found.MeanRatio), mean, 1e-8 * mean) << height << ", " << k;
    }
  }
}

TEST(CellQuality, IsTheSameForAllSizesAndOfTheMirrorImageButForTheSign)
{
  std::mt19937 random(7);
  for (int k = 0; k < 100; ++k)
  {
    Corners corners = RandomCorners(random);
    const CellQuality one = QualityOfCell(corners);
    EXPECT_EQ(one.MeanRatio > 0, Orient3D(corners[0], corners[1], corners[2], corners[3]) > 0);
    for (const int exponent : { -900, -300, -20, 300, 1000 })
    {
      Corners scaled = corners;
      for (Point& p : scaled)
      {
        for (double& x : p)
        {
          x = std::ldexp(x, exponent);
        }
      }
      ExpectSame(QualityOfCell(scaled), one);
    }
    for (Point& p : corners)
    {
      p[0] = -p[0];
    }
    CellQuality mirrored = QualityOfCell(corners);
    mirrored.MeanRatio = -mirrored.MeanRatio;
    ExpectSame(mirrored, one);
  }
}

TEST(CellQuality, OfWhatIsFlatIsNeverUndefined)
{
  const Point a = { { 0.1, 0.2, 0.3 } };
  const Point b = { { 0.4, 0.2, 0.3 } };
  const Point c = { { 0.1, 0.7, 0.3 } };
  const std::vector<Corners> flat = { { { a, a, a, a } }, { { a, a, b, b } }, { { a, a, b, c } },
    { { a, b, { { 0.3, 0.2, 0.3 } }, { { 0.2, 0.2, 0.3 } } } }, // on a line
    { { a, b, c, { { 0.3, 0.4, 0.3 } } } }, { { a, b, c, { { 0.4, 0.7, 0.3 } } } },
    { { a, b, c, { { 0.2, 0.2, 0.3 } } } },
    { { { { 0, 0, 0 } }, { { 0, 0, 0 } }, { { 0, 0, 0 } }, { { 0, 0, 0 } } } } };
  for (std::size_t k = 0; k < flat.size(); ++k)
  {
    for (const double size : { 1.0, 1e-300, 1e-320, 1e300, -1.7e308, 1.7e308 })
    {
      Corners corners = flat[k];
      for (Point& p : corners)
      {
        p = { { p[0] * size, p[1] * size, p[2] * size } };
      }
      if (Orient3D(corners[0], corners[1], corners[2], corners[3]) != 0)
      {
        continue; // by rounding
      }
      const CellQuality found = QualityOfCell(corners);
      for (const double angle : found.DihedralAngles)
      {
        EXPECT_TRUE(angle == 0 || angle == 180) << angle << " of " << k << ", size " << size;
      }
      EXPECT_EQ(found.MinDihedralAngle(), 0) << k;
      EXPECT_EQ(found.RadiusEdgeRatio, Infinity) << k;
      EXPECT_EQ(found.MeanRatio, 0) << k;
    }
  }
}

TEST(CellQuality, CallsACellInAnObliquePlaneFlatAndItsNeighborNot)
{
  std::mt19937 random(9);
  std::uniform_int_distribution<std::int64_t> digits(0, std::int64_t(1) << 50);
  for (int k = 0; k < 100; ++k)
  {
    Corners corners;
    for (Point& p : corners)
    {
      const double x = static_cast<double>(digits(random));
      const double y = static_cast<double>(digits(random));
      p = { { x, y, x + y } }; // without rounding
    }
    CellQuality found = QualityOfCell(corners);
    EXPECT_EQ(found.MeanRatio, 0);
    EXPECT_EQ(found.RadiusEdgeRatio, Infinity);
    EXPECT_TRUE(found.MinDihedralAngle() == 0 && found.MaxDihedralAngle() == 180);
    corners[3][2] = std::nextafter(corners[3][2], Infinity);
    found = QualityOfCell(corners);
    EXPECT_EQ(found.MeanRatio > 0, Orient3D(corners[0], corners[1], corners[2], corners[3]) > 0);
    EXPECT_NE(found.MeanRatio, 0);
    EXPECT_GT(found.MinDihedralAngle(), 0);
  }
}

TEST(CellQuality, OfTheLargestCellIsThatOfAnyOther)
{
  constexpr double most = std::numeric_limits<double>::max();
  const CellQuality found = QualityOfCell({ { { most, most, most }, { -most, most, -most },
    { most, -most, -most }, { -most, -most, most } } });
  EXPECT_NEAR(found.RadiusEdgeRatio, std::sqrt(6.0) / 4, 1e-15);
  EXPECT_NEAR(found.MeanRatio, 1, 1e-15);
}

TEST(CellQuality, OfTheThinnestCellsIsNotThatOfFlatOnes)
{
  // One unit in the last place above its base.
  const double x = 0.7;
  const double above = std::nextafter(x, 1);
  const CellQuality found =
    QualityOfCell({ { { 0, 0, x }, { 1, 0, x }, { 0, 1, x }, { 0.25, 0.25, above } } });
  const double height = above - x;
  EXPECT_NEAR(found.MinDihedralAngle() / (height / std::sqrt(0.125) * 180 / M_PI), 1, 1e-12)
    << "over the long side, which is the farthest from the point";
  EXPECT_GT(found.MeanRatio, 0);
  EXPECT_LT(found.RadiusEdgeRatio, Infinity);
}
