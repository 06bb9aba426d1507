// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "FacetComplex.h"
#include "Sites.h"

#include <quadmath.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

/**
 * The sum of all solid angles in numbers with many digits, as the argument of the product of all
 * facets' complex numbers, of which the turns are counted: an arctangent for each would take half
 * as long again. Such a number has the usual operators, can be made of a double and cast to one,
 * and has functions sqrt(x), and ArgumentOf(y, x), the arctangent in quadruple precision.
 */
namespace testmeshes
{
using namespace insideout;
__extension__ typedef __float128 Quad;

inline Quad sqrt(Quad x)
{
  return sqrtq(x);
}

inline Quad ArgumentOf(Quad y, Quad x)
{
  return atan2q(y, x);
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
 * At most how far off either argument is: about 20 roundings, and those of the vectors. Where this
 * over- or underflows, other numbers have to do it.
 */
template <typename Number>
double ErrorOfArguments(const VectorIn<Number>& a, const VectorIn<Number>& b,
  const VectorIn<Number>& c, double size, double epsilon)
{
  const double la = static_cast<double>(a.Length);
  const double lb = static_cast<double>(b.Length);
  const double lc = static_cast<double>(c.Length);
  return 2 * epsilon * (32 * la * lb * lc + 16 * size * (la * lb + lb * lc + lc * la));
}

/** Whether errors turn the angle by less than 1e-15, and not to the facet's other side. */
template <typename Number>
bool HasDigits(const Arguments<Number>& of, double error)
{
  const double det = std::abs(static_cast<double>(of.Det));
  const double div = static_cast<double>(of.Div);
  return std::max(det, std::abs(div)) > 2e15 * error &&
    error > std::numeric_limits<double>::min() && (div > 0 || det > 2 * error);
}

/** A sum of angles as the argument of a product of complex numbers, of which the turns are counted.
 */
template <typename Number>
class AngleSum
{
public:
  /** Add the argument of div + i det, from -pi to pi, so many times, not both 0. */
  void Add(const Arguments<Number>& of, int times)
  {
    const double scale = std::scalbn(1.0,
      -std::ilogb(
        std::max(std::abs(static_cast<double>(of.Det)), std::abs(static_cast<double>(of.Div)))));
    const Number det = Number(times < 0 ? -scale : scale) * of.Det;
    const bool isBelow = det < Number(0);
    const Number div = Number(scale) * of.Div;
    for (int k = 0; k < std::abs(times); ++k)
    {
      const bool wasBelow = this->Im < Number(0);
      const Number re = this->Re * div - this->Im * det;
      this->Im = this->Re * det + this->Im * div;
      this->Re = re;
      if (wasBelow == isBelow && wasBelow != (this->Im < Number(0)))
      {
        this->Turns += wasBelow ? -1 : 1;
      }
      this->Shorten();
    }
  }

  Quad Value() const
  {
    return ArgumentOf(this->Im, this->Re) + this->Turns * 2 * ArgumentOf(Number(0), Number(-1));
  }

private:
  void Shorten()
  {
    const double length =
      std::max(std::abs(static_cast<double>(this->Re)), std::abs(static_cast<double>(this->Im)));
    if (!(length < 1e50 && length > 1e-50))
    {
      const double scale = std::scalbn(1.0, -std::ilogb(length));
      this->Re = this->Re * Number(scale);
      this->Im = this->Im * Number(scale);
    }
  }

  Number Re = Number(1);
  Number Im = Number(0);
  std::int64_t Turns = 0;
};

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

/** Half the solid angle of a triangle at a site, with exact arguments; NaN if they cannot be had.
 */
Quad HalfSolidAngleInLong(const Site& site, const std::array<Point, 3>& corners);

/** @param[in] epsilon at most the relative error of a sum, product or root */
template <typename Number>
double BruteForceWindingNumber(const FacetComplex& surface, const Site& site, double epsilon)
{
  std::vector<VectorIn<Number>> vectors;
  vectors.reserve(surface.Points.size());
  for (const Point& point : surface.Points)
  {
    vectors.push_back(FromSite<Number>(site, point));
  }
  const double size = Size(surface, site);
  AngleSum<Number> sum;
  Quad others = 0;
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    const int multiplicity = surface.Multiplicity[f];
    if (multiplicity == 0)
    {
      continue;
    }
    const Triangle& t = surface.Facets[f];
    const VectorIn<Number>& a = vectors[t[0]];
    const VectorIn<Number>& b = vectors[t[1]];
    const VectorIn<Number>& c = vectors[t[2]];
    const Arguments<Number> of = HalfSolidAngle(a, b, c);
    if (HasDigits(of, ErrorOfArguments(a, b, c, size, epsilon)))
    {
      sum.Add(of, multiplicity);
    }
    else
    {
      others += multiplicity *
        HalfSolidAngleInLong(
          site, { surface.Points[t[0]], surface.Points[t[1]], surface.Points[t[2]] });
    }
  }
  const Quad pi = ArgumentOf(Number(0), Number(-1));
  return static_cast<double>((sum.Value() + others) / (2 * pi));
}
} // namespace testmeshes
