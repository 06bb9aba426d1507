// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/ScaledPoints.h"

#include "Common/ParallelLoop.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
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

PowerOfTwo::PowerOfTwo(int exponent)
{
  // Upwards in two steps, because the factor may overflow; downwards in one, because each step may
  // round.
  const int second = std::max(exponent, 0) / 2;
  this->Factors[0] = std::ldexp(1.0, exponent - second);
  this->Factors[1] = std::ldexp(1.0, second);
}

bool IsNear(const Point& scaled)
{
  constexpr double Afar = 0x1p50; // relative to the surface's size: beyond, w is below 2^-90
  return std::abs(scaled[0]) <= Afar && std::abs(scaled[1]) <= Afar && std::abs(scaled[2]) <= Afar;
}

std::vector<Point> ScaledPoints(const std::vector<Point>& points, int exponent)
{
  const PowerOfTwo power(exponent);
  std::vector<Point> scaled(points.size());
  const double nanosecondsPerPoint = 3;
  ParallelLoop(points.size(), nanosecondsPerPoint,
    [&](std::size_t p)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        scaled[p][axis] = power.Times(points[p][axis]);
      }
    });
  return scaled;
}
} // namespace insideout
