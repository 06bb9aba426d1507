// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/SitePredicates.h"

#include <CGAL/Mpzf.h>
#include <CGAL/determinant.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>

namespace insideout
{
namespace
{
using Exact = CGAL::Mpzf;
using ExactVector = std::array<Exact, 3>;

// With u = 2^-53, the forward error of normal . d is below 16 u |edge| |edge| |d| (3 from the
// difference, 6 from the normal and 3 from the product), that of a determinant of differences below
// 16 u times its permanent; with room to spare.
constexpr double RelativeError = 0x1p-48;

// Coordinates are below 1. What is decided is above the first, far from where products underflow; a
// difference below the second has lost digits.
constexpr double LeastDecided = 1e-250;
constexpr double LeastDifference = 0x1p-45;

/** From the site to a point. */
Point FromSite(const PreparedSite& site, const Point& point)
{
  Point d;
  for (int axis = 0; axis < 3; ++axis)
  {
    d[axis] = (point[axis] - site.High[axis]) - site.Low[axis];
  }
  return d;
}

ExactVector ExactFromSite(const Site& site, const Point& point)
{
  ExactVector d;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int k = 0; k < 4; ++k)
    {
      d[axis] += Exact(site.Weights[k]) * (Exact(point[axis]) - Exact(site.Corners[k][axis]));
    }
  }
  return d;
}

ExactVector ExactCross(const ExactVector& a, const ExactVector& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

int ExactSign(const Site& site, const Point& a, const Point& b, const Point& c)
{
  const ExactVector u = ExactFromSite(site, a);
  const ExactVector v = ExactFromSite(site, b);
  const ExactVector w = ExactFromSite(site, c);
  return static_cast<int>(
    CGAL::sign(CGAL::determinant<Exact>(u[0], u[1], u[2], v[0], v[1], v[2], w[0], w[1], w[2])));
}

/** At least its length. */
double SumOfComponents(const Point& d)
{
  return std::abs(d[0]) + std::abs(d[1]) + std::abs(d[2]);
}

double LargestComponent(const Point& d)
{
  return std::max(std::max(std::abs(d[0]), std::abs(d[1])), std::abs(d[2]));
}
} // namespace

PlaneOfTriangle::PlaneOfTriangle(const std::array<Point, 3>& corners)
{
  const auto& [a, b, c] = corners;
  const Point e = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
  const Point f = { c[0] - a[0], c[1] - a[1], c[2] - a[2] };
  this->Normal = { e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2],
    e[0] * f[1] - e[1] * f[0] };
  this->UndecidedSide = RelativeError * SumOfComponents(e) * SumOfComponents(f);
}

int QuickSide(const PlaneOfTriangle& plane, const Point& d)
{
  const double side = d[0] * plane.Normal[0] + d[1] * plane.Normal[1] + d[2] * plane.Normal[2];
  const double length = SumOfComponents(d);
  const bool decided =
    std::abs(side) > plane.UndecidedSide * length + LeastDecided && length > LeastDifference;
  return !decided ? 0 : side < 0 ? 1 : -1;
}

int SideOfPlane(
  const PlaneOfTriangle& plane, const std::array<Point, 3>& triangle, const PreparedSite& site)
{
  const int side = QuickSide(plane, FromSite(site, triangle[0]));
  return side != 0 ? side : -ExactSign(site.Exact, triangle[0], triangle[1], triangle[2]);
}

int SideOfPlane(
  const PlaneOfTriangle& plane, const std::array<Point, 3>& triangle, const Point& point)
{
  const int side = QuickSide(
    plane, { triangle[0][0] - point[0], triangle[0][1] - point[1], triangle[0][2] - point[2] });
  return side != 0 ? side : -ExactSign(SiteAt(point), triangle[0], triangle[1], triangle[2]);
}

int SignOfDeterminant(const PreparedSite& site, const Point& a, const Point& b, const Point& c)
{
  const Point u = FromSite(site, a);
  const Point v = FromSite(site, b);
  const Point w = FromSite(site, c);
  double determinant = 0;
  double permanent = 0;
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    const double first = v[j] * w[k];
    const double second = v[k] * w[j];
    determinant += u[i] * (first - second);
    permanent += std::abs(u[i]) * (std::abs(first) + std::abs(second));
  }
  const bool precise = LargestComponent(u) > LeastDifference &&
    LargestComponent(v) > LeastDifference && LargestComponent(w) > LeastDifference;
  if (std::abs(determinant) > RelativeError * permanent + LeastDecided && precise)
  {
    return determinant > 0 ? 1 : -1;
  }
  return ExactSign(site.Exact, a, b, c);
}

bool IsInTriangle(const std::array<Point, 3>& triangle, const Site& site)
{
  std::array<ExactVector, 3> d;
  for (int k = 0; k < 3; ++k)
  {
    d[k] = ExactFromSite(site, triangle[k]);
  }
  // In the plane all three are multiples of the normal.
  const std::array<ExactVector, 3> products = { ExactCross(d[0], d[1]), ExactCross(d[1], d[2]),
    ExactCross(d[2], d[0]) };
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto sign = [&](int k) { return static_cast<int>(CGAL::sign(products[k][axis])); };
    const int least = std::min(std::min(sign(0), sign(1)), sign(2));
    const int most = std::max(std::max(sign(0), sign(1)), sign(2));
    if (least < 0 && most > 0)
    {
      return false;
    }
  }
  return true;
}

bool IsOnLine(const Point& a, const Point& b, const Site& site)
{
  const ExactVector product = ExactCross(ExactFromSite(site, a), ExactFromSite(site, b));
  return CGAL::is_zero(product[0]) && CGAL::is_zero(product[1]) && CGAL::is_zero(product[2]);
}
} // namespace insideout
