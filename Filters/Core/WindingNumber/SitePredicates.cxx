// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/SitePredicates.h"

#include "Common/Numbers.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace insideout
{
namespace
{
using ExactVector = Vector<DyadicNumber>;

// Let u = 2^-53. The forward error of normal . d is below 16 u |edge| |edge| |d|: 3 from the
// difference, 6 from the normal and 3 from the product. That of a determinant of differences is
// below 16 u times its permanent. Both leave room to spare.
constexpr double RelativeError = 0x1p-48;

// Coordinates are below 1. Only values above the first are decided, far from where products
// underflow; a difference below the second has lost digits.
constexpr double LeastDecided = 1e-250;
constexpr double LeastDifference = 0x1p-45;

// The same for long doubles, which may be no longer than doubles. A rounded site is known to some
// 2^-104.
constexpr long double LongRelativeError = 16 * std::numeric_limits<long double>::epsilon();
constexpr long double LeastLongDifference = 0x1p-36L;

/** From the site to a point. If the site is a point, one difference per axis suffices. */
ExactVector ExactVectorFrom(const Site& site, const Point& point)
{
  const Point& first = site.Corners[0];
  if (std::any_of(site.Corners.begin(), site.Corners.end(),
        [&](const Point& corner) { return corner != first; }))
  {
    return VectorFrom<DyadicNumber>(site, point);
  }
  ExactVector vector;
  for (int axis = 0; axis < 3; ++axis)
  {
    vector[axis] = DyadicNumber(point[axis]) - DyadicNumber(first[axis]);
  }
  return vector;
}

/** From the site to a point, rounded. */
Point RoundedVectorFrom(const PreparedSite& site, const Point& point)
{
  Point d;
  for (int axis = 0; axis < 3; ++axis)
  {
    d[axis] = (point[axis] - site.High[axis]) - site.Low[axis];
  }
  return d;
}

/** At least its length. */
double SumOfComponents(const Point& d)
{
  return std::abs(d[0]) + std::abs(d[1]) + std::abs(d[2]);
}

/** The sign of the determinant of the vectors from the site, 0 where this type does not decide. */
template <typename Number>
int QuickSign(const PreparedSite& site, const Point& a, const Point& b, const Point& c,
  Number relativeError, Number leastDifference)
{
  const std::array<Point, 3> points = { a, b, c };
  std::array<Vector<Number>, 3> d;
  bool precise = true;
  for (int k = 0; k < 3; ++k)
  {
    Number largest = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      d[k][axis] = (Number(points[k][axis]) - site.High[axis]) - site.Low[axis];
      largest = std::max(largest, std::abs(d[k][axis]));
    }
    precise = precise && largest > leastDifference;
  }
  const auto& [u, v, w] = d;
  Number determinant = 0;
  Number permanent = 0;
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    const Number first = v[j] * w[k];
    const Number second = v[k] * w[j];
    determinant += u[i] * (first - second);
    permanent += std::abs(u[i]) * (std::abs(first) + std::abs(second));
  }
  const bool decided = std::abs(determinant) > relativeError * permanent + LeastDecided && precise;
  return !decided ? 0 : determinant > 0 ? 1 : -1;
}
} // namespace

PlaneOfTriangle::PlaneOfTriangle(const std::array<Point, 3>& corners)
{
  const auto& [a, b, c] = corners;
  this->Normal = NormalOf(a, b, c);
  this->UndecidedSide =
    RelativeError * SumOfComponents(Difference(b, a)) * SumOfComponents(Difference(c, a));
}

int QuickSide(const PlaneOfTriangle& plane, const Point& d)
{
  const double side = Dot(d, plane.Normal);
  const double length = SumOfComponents(d);
  const bool decided =
    std::abs(side) > plane.UndecidedSide * length + LeastDecided && length > LeastDifference;
  return !decided ? 0 : side < 0 ? 1 : -1;
}

int SideOfPlane(
  const PlaneOfTriangle& plane, const std::array<Point, 3>& triangle, const PreparedSite& site)
{
  const int side = QuickSide(plane, RoundedVectorFrom(site, triangle[0]));
  return side != 0 ? side : -SignOfDeterminant(site, triangle[0], triangle[1], triangle[2]);
}

int SideOfPlane(
  const PlaneOfTriangle& plane, const std::array<Point, 3>& triangle, const Point& point)
{
  const int side = QuickSide(plane, Difference(triangle[0], point));
  return side != 0 ? side
                   : -SignOfDeterminant(SiteAt(point), triangle[0], triangle[1], triangle[2]);
}

int SignOfDeterminant(const Site& site, const Point& a, const Point& b, const Point& c)
{
  return CGAL::sign(
    Determinant(ExactVectorFrom(site, a), ExactVectorFrom(site, b), ExactVectorFrom(site, c)));
}

int SignOfDeterminant(const PreparedSite& site, const Point& a, const Point& b, const Point& c)
{
  const int quick = QuickSign<double>(site, a, b, c, RelativeError, LeastDifference);
  if (quick != 0)
  {
    return quick;
  }
  const int sign = QuickSign<long double>(site, a, b, c, LongRelativeError, LeastLongDifference);
  return sign != 0 ? sign : SignOfDeterminant(site.Exact, a, b, c);
}

bool IsInTriangle(const std::array<Point, 3>& triangle, const Site& site)
{
  std::array<ExactVector, 3> d;
  for (int k = 0; k < 3; ++k)
  {
    d[k] = ExactVectorFrom(site, triangle[k]);
  }
  // In the plane all three are multiples of the normal.
  const std::array<ExactVector, 3> products = { Cross(d[0], d[1]), Cross(d[1], d[2]),
    Cross(d[2], d[0]) };
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
  const ExactVector product = Cross(ExactVectorFrom(site, a), ExactVectorFrom(site, b));
  return CGAL::is_zero(product[0]) && CGAL::is_zero(product[1]) && CGAL::is_zero(product[2]);
}
} // namespace insideout
