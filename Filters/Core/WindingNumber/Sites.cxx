// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/Sites.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
namespace
{
constexpr std::size_t SmallSize = 4096; // not worth a second thread

/** a + b = sum + the value returned, exactly (Knuth). */
double TwoSum(double a, double b, double& sum)
{
  sum = a + b;
  const double bRounded = sum - a;
  const double aRounded = sum - bRounded;
  return (a - aRounded) + (b - bRounded);
}

} // namespace

RoundedSite::RoundedSite(const Site& site)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    double high = 0;
    double low = 0;
    for (int k = 0; k < 4; ++k)
    {
      const double weight = site.Weights[k];
      const double product = weight * site.Corners[k][axis];
      low += weight == 0.25 ? 0 : std::fma(weight, site.Corners[k][axis], -product);
      low += TwoSum(high, product, high);
    }
    this->Low[axis] = TwoSum(high, low, this->High[axis]);
  }
}

int LargestExponent(const std::vector<Point>& points)
{
  double largest = 0;
  for (const Point& p : points)
  {
    largest = std::max({ largest, std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  return exponent;
}

std::vector<Point> ScaledPoints(const std::vector<Point>& points, int exponent)
{
  // In two steps, for 2^-exponent itself may overflow.
  const double first = std::ldexp(1.0, -(exponent / 2));
  const double second = std::ldexp(1.0, -(exponent - exponent / 2));
  std::vector<Point> scaled(points.size());
#pragma omp parallel for if (points.size() > SmallSize)
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      scaled[p][axis] = points[p][axis] * first * second;
    }
  }
  return scaled;
}

std::vector<Tetrahedron> CellsOfPoints(std::size_t count)
{
  std::vector<Tetrahedron> cells(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const Id p = static_cast<Id>(i);
    cells[i] = { { p, p, p, p } };
  }
  return cells;
}
} // namespace insideout
