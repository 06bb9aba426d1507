// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/SolidAngle.h"

#include "Common/GmpMemory.h" // for MPFR, too
#include "Common/Vectors.h"
#include "WindingNumber/Pi.h"
#include "WindingNumber/SitePredicates.h"

#include <boost/multiprecision/mpfr.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace insideout
{
namespace
{
template <int Digits>
using Precise = boost::multiprecision::number<
  boost::multiprecision::mpfr_float_backend<Digits, boost::multiprecision::allocate_stack>,
  boost::multiprecision::et_off>;

// Enough if the site is at least some 1e-30 sizes away from corners and edges.
constexpr int FewDigits = 50;

// Enough for all sites. Vectors from a site are multiples of 2^-1134, a double's least bit times
// that of a weight, so their determinant is a multiple of 2^-3402: both are exact, and |z|, which
// is not less than the determinant, has 50 digits beyond.
constexpr int ManyDigits = 1080;

// The required error of z, relative to |z|, and a bound of all roundings' effect relative to that
// of one.
constexpr double RelativeError = 0x1p-60;
constexpr double RoundingErrors = 0x1p8;

// Relative to the product of the three distances; see SolidAngleProduct.cxx.
constexpr double LeastSquaredModulus = 0x1p-12;
constexpr double UndecidedDeterminant = 0x1p-47;

// Above it, a product of three distances and its square are far from underflow.
constexpr double LeastProduct = 1e-100;

// The same for long doubles of 64 bits, and the squared distance from which on the two doubles of a
// rounded site have all of these bits. Coordinates are below 1.
constexpr double LeastLongModulus = 0x1p-14;
constexpr double UndecidedLongDeterminant = 0x1p-56;
constexpr double LeastSquaredDistance = 0x1p-70;

/** The largest difference of coordinates for VectorFrom. */
double Extent(const std::array<Point, 3>& triangle, const Site& site)
{
  double extent = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const Point& from : site.Corners)
    {
      for (const Point& to : triangle)
      {
        extent = std::max(extent, std::abs(to[axis] - from[axis]));
      }
    }
  }
  return extent;
}

/** The unit vector from a site to a point; false if they are too near for long doubles. */
bool UnitVector(const RoundedSite& site, const Point& point, Vector<long double>& unit)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    unit[axis] = (static_cast<long double>(point[axis]) - site.High[axis]) - site.Low[axis];
  }
  const long double squared = Dot(unit, unit);
  for (long double& x : unit)
  {
    x /= std::sqrt(squared);
  }
  return squared > LeastSquaredDistance && std::numeric_limits<long double>::digits >= 64;
}

/** +1 where the triangle's normal points away from the site, -1 towards it, 0 in plane. */
int Side(const std::array<Point, 3>& triangle, const Site& site)
{
  return SignOfDeterminant(PreparedSite(site), triangle[0], triangle[1], triangle[2]);
}

/** z of modulus 1 from its real part and the absolute value of its imaginary part; 1 in the
 * triangle's plane. */
std::complex<double> OnSide(int side, double real, double imaginary)
{
  if (side == 0)
  {
    return 1.0;
  }
  // A known side must not be lost by underflow in the conversion to double.
  const double least = 1e-180;
  return { real, side * std::max(imaginary, least) };
}

/**
 * In long doubles of 64 bits, whose error of z is 40 * 2^-64 unless z is close to 0. If they do not
 * decide the side, an exact predicate does.
 *
 * @return whether they know z to 1e-13 of its modulus
 */
bool QuickHalfSolidAngle(
  const std::array<Point, 3>& triangle, const Site& site, std::complex<double>& z)
{
  const RoundedSite rounded(site);
  Vector<long double> a, b, c;
  if (!UnitVector(rounded, triangle[0], a) || !UnitVector(rounded, triangle[1], b) ||
    !UnitVector(rounded, triangle[2], c))
  {
    return false;
  }
  const long double real = 1 + ((Dot(a, b) + Dot(c, a)) + Dot(b, c));
  const long double imaginary = Determinant(a, b, c);
  const long double modulus = std::sqrt(real * real + imaginary * imaginary);
  if (!(modulus > LeastLongModulus))
  {
    return false;
  }
  const int side = std::abs(imaginary) > UndecidedLongDeterminant ? (imaginary > 0 ? 1 : -1)
                                                                  : Side(triangle, site);
  z = OnSide(
    side, static_cast<double>(real / modulus), static_cast<double>(std::abs(imaginary) / modulus));
  return true;
}

/**
 * In numbers of the given precision, for a side other than 0.
 *
 * @return whether they know z to RelativeError
 */
template <int Digits>
bool PreciseHalfSolidAngle(
  const std::array<Point, 3>& triangle, const Site& site, int side, std::complex<double>& z)
{
  using Number = Precise<Digits>;
  const Vector<Number> a = VectorFrom<Number>(site, triangle[0]);
  const Vector<Number> b = VectorFrom<Number>(site, triangle[1]);
  const Vector<Number> c = VectorFrom<Number>(site, triangle[2]);
  const Number lengthA = sqrt(Dot(a, a));
  const Number lengthB = sqrt(Dot(b, b));
  const Number lengthC = sqrt(Dot(c, c));
  const Number all = lengthA * lengthB * lengthC;
  const Number real = all + Dot(a, b) * lengthC + Dot(b, c) * lengthA + Dot(c, a) * lengthB;
  const Number imaginary = abs(Determinant(a, b, c));
  const Number modulus = sqrt(real * real + imaginary * imaginary);
  if (modulus == 0)
  {
    return false;
  }
  z = OnSide(side, static_cast<double>(Number(real / modulus)),
    static_cast<double>(Number(imaginary / modulus)));

  // The error of a vector is relative to the extent, not to its own length.
  const Number least = std::min({ lengthA, lengthB, lengthC });
  // Not numeric_limits' epsilon: threads that call it first write it at the same time.
  const Number epsilon = ldexp(Number(1), 1 - std::numeric_limits<Number>::digits);
  const Number error = epsilon * RoundingErrors * Extent(triangle, site) * all;
  return modulus * least * RelativeError > error;
}
} // namespace

std::complex<double> HalfSolidAngle(const std::array<Point, 3>& triangle, const Site& site)
{
  std::complex<double> z;
  if (QuickHalfSolidAngle(triangle, site, z))
  {
    return z;
  }
  const int side = Side(triangle, site);
  if (side != 0 && !PreciseHalfSolidAngle<FewDigits>(triangle, site, side, z))
  {
    // This precision always suffices.
    PreciseHalfSolidAngle<ManyDigits>(triangle, site, side, z);
  }
  return side == 0 ? 1.0 : z;
}

double WindingNumberOfTriangle(const std::array<Point, 3>& triangle, const Point& p)
{
  const Point a = Difference(triangle[0], p);
  const Point b = Difference(triangle[1], p);
  const Point c = Difference(triangle[2], p);
  const double lengthA = std::sqrt(Dot(a, a));
  const double lengthB = std::sqrt(Dot(b, b));
  const double lengthC = std::sqrt(Dot(c, c));
  const double all = lengthA * lengthB * lengthC;
  const double div = all + Dot(a, b) * lengthC + Dot(b, c) * lengthA + Dot(c, a) * lengthB;
  const double det = Determinant(a, b, c);
  const bool isClear =
    div * div + det * det >= LeastSquaredModulus * all * all && all > LeastProduct;
  if (isClear && (div > 0 || std::abs(det) > UndecidedDeterminant * all))
  {
    return std::atan2(det, div) / (2 * Pi);
  }
  return std::arg(HalfSolidAngle(triangle, SiteAt(p))) / (2 * Pi);
}
} // namespace insideout
