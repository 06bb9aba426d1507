// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace insideout
{
/**
 * The sum of two doubles, the second of which is at most half a unit in the last place of the
 * first: 106 binary digits (Dekker 1971). The usual operators, in round-to-nearest.
 */
struct DoubleDouble
{
  double High = 0;
  double Low = 0;

  DoubleDouble() = default;
  explicit DoubleDouble(double x)
    : High(x)
  {
  }
  DoubleDouble(double high, double low)
    : High(high)
    , Low(low)
  {
  }

  explicit operator double() const { return this->High; }
};

/** Relative error of each of the operations (Joldes, Muller and Popescu 2017), rounded up. */
constexpr double DoubleDoubleEpsilon = 0x1p-102;

/** a + b without error, for |a| >= |b|. */
inline DoubleDouble QuickTwoSum(double a, double b)
{
  const double sum = a + b;
  return { sum, b - (sum - a) };
}

/** a + b without error (Knuth). */
inline DoubleDouble TwoSum(double a, double b)
{
  const double sum = a + b;
  const double of = sum - a;
  return { sum, (a - (sum - of)) + (b - of) };
}

inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b)
{
  const DoubleDouble high = TwoSum(a.High, b.High);
  const DoubleDouble low = TwoSum(a.Low, b.Low);
  const DoubleDouble sum = QuickTwoSum(high.High, high.Low + low.High);
  return QuickTwoSum(sum.High, sum.Low + low.Low);
}

inline DoubleDouble operator-(const DoubleDouble& a)
{
  return { -a.High, -a.Low };
}

inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b)
{
  return a + -b;
}

inline DoubleDouble& operator-=(DoubleDouble& a, const DoubleDouble& b)
{
  return a = a - b;
}

inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b)
{
  const double product = a.High * b.High;
  const double error = std::fma(a.High, b.High, -product);
  return QuickTwoSum(
    product, error + std::fma(a.High, b.Low, std::fma(a.Low, b.High, a.Low * b.Low)));
}

inline bool operator<(const DoubleDouble& a, const DoubleDouble& b)
{
  return a.High < b.High || (a.High == b.High && a.Low < b.Low);
}

/** One Newton step from the root of the first part. */
inline DoubleDouble sqrt(const DoubleDouble& x)
{
  if (!(x.High > 0))
  {
    return DoubleDouble(std::sqrt(x.High));
  }
  const double root = std::sqrt(x.High);
  const DoubleDouble rest = x - DoubleDouble(root) * DoubleDouble(root);
  return QuickTwoSum(root, rest.High / (2 * root));
}
} // namespace insideout
