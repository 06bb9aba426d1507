// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <vector>

/** Scaling by powers of two: it rounds nothing, and keeps products from over- and underflow. */
namespace insideout
{
/** The largest absolute value of a coordinate; 0 for no points. */
double LargestCoordinate(const std::vector<Point>& points);

/** The least exponent e with the absolute values of all coordinates below 2^e; 0 if all are 0. */
int LargestExponent(const std::vector<Point>& points);

/** Multiplies by 2^exponent, from -1074 to 2046, like std::ldexp but fast. */
class PowerOfTwo
{
public:
  explicit PowerOfTwo(int exponent);

  double Times(double x) const { return x * this->Factors[0] * this->Factors[1]; }
  Point Times(const Point& p) const
  {
    return { { this->Times(p[0]), this->Times(p[1]), this->Times(p[2]) } };
  }

private:
  double Factors[2];
};

/** Whether a point is nearer than 2^50 sizes of a surface of size 1: beyond, the surface is like
 * one point, and its w below 2^-90. False also if the point is not finite. */
bool IsNear(const Point& scaled);

/** The points times a power of two. */
std::vector<Point> ScaledPoints(const std::vector<Point>& points, int exponent);
} // namespace insideout
