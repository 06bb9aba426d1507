// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <vector>

/** Sizes by powers of two: scaling so rounds nothing, and products neither over- nor underflow. */
namespace insideout
{
/** The largest absolute value of a coordinate; 0 for no points. */
double LargestCoordinate(const std::vector<Point>& points);

/** The exponent e such that the absolute value of every coordinate is below 2^e; 0 where all are 0.
 */
int LargestExponent(const std::vector<Point>& points);

/** Multiplies by 2^exponent, which is from -1074 to 2046: as std::ldexp does, quickly. */
class PowerOfTwo
{
public:
  explicit PowerOfTwo(int exponent);

  double Times(double x) const { return x * this->Factors[0] * this->Factors[1]; }

private:
  double Factors[2];
};

/** From 2^50 times its size away all of a surface is one place, and its w is below 2^-90: whether a
 * point is nearer, where the surface's size is scaled to 1. False where it is not finite, too. */
bool IsNear(const Point& scaled);

/** The points times a power of two. */
std::vector<Point> ScaledPoints(const std::vector<Point>& points, int exponent);
} // namespace insideout
