// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "WindingNumber/Sites.h"

#include <quadmath.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

/**
 * What sums of all solid angles in numbers with many digits have in common. Such a sum is the
 * argument of the product of all facets' complex numbers, of which the turns are counted: an
 * arctangent for each would take half as long again. A number has the usual operators, can be made
 * of a double, and has a function sqrt(x).
 */
namespace testmeshes
{
using namespace insideout;
__extension__ typedef __float128 Quad;

inline Quad sqrt(Quad x)
{
  return sqrtq(x);
}

inline Quad Pi()
{
  return atan2q(0, -1);
}

/** From the site to a point, times 4, and its length. */
template <typename Number>
struct VectorIn
{
  Number X, Y, Z, Length;
};

template <typename Number>
VectorIn<Number> FromSite(const Site& site, const Point& point)
{
  const auto component = [&](int axis)
  {
    Number sum = Number(4) * Number(point[axis]);
    for (const Point& corner : site.Corners)
    {
      sum -= Number(corner[axis]);
    }
    return sum;
  };
  VectorIn<Number> v = { component(0), component(1), component(2), Number(0) };
  v.Length = sqrt(v.X * v.X + v.Y * v.Y + v.Z * v.Z);
  return v;
}

template <typename Number>
Number Dot(const VectorIn<Number>& a, const VectorIn<Number>& b)
{
  return a.X * b.X + a.Y * b.Y + a.Z * b.Z;
}

/** Both arguments of the arctangent that is half a solid angle. */
template <typename Number>
struct Arguments
{
  Number Det, Div;
};

/** Van Oosterom and Strackee 1983, equation 8. */
template <typename Number>
Arguments<Number> HalfSolidAngle(
  const VectorIn<Number>& a, const VectorIn<Number>& b, const VectorIn<Number>& c)
{
  return { a.X * (b.Y * c.Z - b.Z * c.Y) + a.Y * (b.Z * c.X - b.X * c.Z) +
      a.Z * (b.X * c.Y - b.Y * c.X),
    a.Length * b.Length * c.Length + Dot(a, b) * c.Length + Dot(b, c) * a.Length +
      Dot(c, a) * b.Length };
}

/**
 * At most how far off either argument is: about 20 roundings, and those of the vectors, whose
 * lengths these are. Where this over- or underflows, other numbers have to do it.
 */
template <typename Real>
Real ErrorOfArguments(Real a, Real b, Real c, double size, double epsilon)
{
  return 2 * epsilon * (32 * a * b * c + 16 * size * (a * b + b * c + c * a));
}

/**
 * Whether errors turn the angle by less than 1e-15, and not to the facet's other side.
 * @param[in] det the absolute value
 * @param[in] largest the larger absolute value of the two arguments
 */
template <typename Real>
auto HasDigits(Real det, Real div, Real largest, Real error)
{
  return (largest > 2e15 * error) & (error > std::numeric_limits<double>::min()) &
    ((div > 0) | (det > 2 * error));
}

/** The largest coordinate. */
inline double Size(const FacetComplex& surface, const Site& site)
{
  double size = 0;
  const auto add = [&](const Point& point)
  {
    for (const double x : point)
    {
      size = std::max(size, std::abs(x));
    }
  };
  std::for_each(surface.Points.begin(), surface.Points.end(), add);
  std::for_each(site.Corners.begin(), site.Corners.end(), add);
  return size;
}

inline std::array<Point, 3> CornersOf(const FacetComplex& surface, const Triangle& facet)
{
  return { { surface.Points[facet[0]], surface.Points[facet[1]], surface.Points[facet[2]] } };
}

/** Half the solid angle of a triangle at a site, with exact arguments; NaN if they cannot be had.
 */
Quad HalfSolidAngleInLong(const Site& site, const std::array<Point, 3>& corners);
} // namespace testmeshes
