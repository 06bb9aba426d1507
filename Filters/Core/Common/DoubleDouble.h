// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace insideout
{
/**
 * The sum of two doubles, the second of which is at most half a unit in the last place of the
 * first: 106 binary digits (Dekker 1971). The usual operators require round-to-nearest. Real is
 * double, or a vector of doubles with FusedMultiplyAdd.
 */
template <typename Real>
struct DoubleDoubleOf
{
  Real High = {};
  Real Low = {};

  DoubleDoubleOf() = default;
  explicit DoubleDoubleOf(Real x)
    : High(x)
  {
  }
  DoubleDoubleOf(Real high, Real low)
    : High(high)
    , Low(low)
  {
  }

  explicit operator double() const { return this->High; }
};

using DoubleDouble = DoubleDoubleOf<double>;

/** Relative error of each operation (Joldes, Muller and Popescu 2017), rounded up. */
constexpr double DoubleDoubleEpsilon = 0x1p-102;

/** a * b + c, rounded once. */
template <typename Real>
Real FusedMultiplyAdd(Real a, Real b, Real c)
{
  return std::fma(a, b, c);
}

/** a + b without error, for |a| >= |b|. */
template <typename Real>
DoubleDoubleOf<Real> QuickTwoSum(Real a, Real b)
{
  const Real sum = a + b;
  return { sum, b - (sum - a) };
}

/** a + b without error (Knuth). */
template <typename Real>
DoubleDoubleOf<Real> TwoSum(Real a, Real b)
{
  const Real sum = a + b;
  const Real of = sum - a;
  return { sum, (a - (sum - of)) + (b - of) };
}

template <typename Real>
DoubleDoubleOf<Real> operator+(const DoubleDoubleOf<Real>& a, const DoubleDoubleOf<Real>& b)
{
  const DoubleDoubleOf<Real> high = TwoSum(a.High, b.High);
  const DoubleDoubleOf<Real> low = TwoSum(a.Low, b.Low);
  const DoubleDoubleOf<Real> sum = QuickTwoSum<Real>(high.High, high.Low + low.High);
  return QuickTwoSum<Real>(sum.High, sum.Low + low.Low);
}

template <typename Real>
DoubleDoubleOf<Real> operator-(const DoubleDoubleOf<Real>& a)
{
  return { -a.High, -a.Low };
}

template <typename Real>
DoubleDoubleOf<Real> operator-(const DoubleDoubleOf<Real>& a, const DoubleDoubleOf<Real>& b)
{
  return a + -b;
}

template <typename Real>
DoubleDoubleOf<Real>& operator-=(DoubleDoubleOf<Real>& a, const DoubleDoubleOf<Real>& b)
{
  return a = a - b;
}

template <typename Real>
DoubleDoubleOf<Real> operator*(const DoubleDoubleOf<Real>& a, const DoubleDoubleOf<Real>& b)
{
  const Real product = a.High * b.High;
  const Real error = FusedMultiplyAdd<Real>(a.High, b.High, -product);
  const Real low = FusedMultiplyAdd<Real>(a.Low, b.High, a.Low * b.Low);
  return QuickTwoSum<Real>(product, error + FusedMultiplyAdd<Real>(a.High, b.Low, low));
}
} // namespace insideout
