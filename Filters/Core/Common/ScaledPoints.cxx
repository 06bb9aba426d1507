// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/ScaledPoints.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
namespace
{
constexpr std::size_t SmallSize = 4096; // not worth a second thread
} // namespace

double LargestCoordinate(const std::vector<Point>& points)
{
  double largest = 0;
  for (const Point& p : points)
  {
    largest = std::max({ largest, std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
  }
  return largest;
}

int LargestExponent(const std::vector<Point>& points)
{
  int exponent = 0;
  std::frexp(LargestCoordinate(points), &exponent);
  return exponent;
}

std::vector<Point> ScaledPoints(const std::vector<Point>& points, int exponent)
{
  // Upwards in two steps, for the factor itself may overflow; downwards in one, for each may round.
  const int second = std::max(exponent, 0) / 2;
  const double factors[2] = { std::ldexp(1.0, exponent - second), std::ldexp(1.0, second) };
  std::vector<Point> scaled(points.size());
#pragma omp parallel for if (points.size() > SmallSize)
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      scaled[p][axis] = points[p][axis] * factors[0] * factors[1];
    }
  }
  return scaled;
}
} // namespace insideout
