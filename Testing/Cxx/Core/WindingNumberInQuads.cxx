// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumberInQuads.h"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <quadmath.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace testmeshes
{
using namespace insideout;

namespace
{
__extension__ typedef __float128 Quad;
constexpr Quad Epsilon = 1 / (Quad(1ULL << 56) * Quad(1ULL << 56));

// Enough for determinants of three vectors, themselves of coordinates with exponents that far
// apart.
constexpr int ManyBits = 1200;
constexpr int MostExponentsApart = 250;
using Long = boost::multiprecision::number<
  boost::multiprecision::cpp_bin_float<ManyBits, boost::multiprecision::digit_base_2>,
  boost::multiprecision::et_off>;

Quad Root(Quad x)
{
  return sqrtq(x);
}

Long Root(const Long& x)
{
  return sqrt(x);
}

/** From the site to a point, times 4, and its length. */
template <typename Number>
struct VectorIn
{
  Number X, Y, Z, Length;
};
using QuadVector = VectorIn<Quad>;

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
  VectorIn<Number> v = { component(0), component(1), component(2), 0 };
  v.Length = Root(v.X * v.X + v.Y * v.Y + v.Z * v.Z);
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

/** At most how far off either argument is: about 20 roundings, and those of the vectors. */
Quad ErrorOfArguments(const QuadVector& a, const QuadVector& b, const QuadVector& c, Quad size)
{
  return Epsilon *
    (32 * a.Length * b.Length * c.Length +
      16 * size * (a.Length * b.Length + b.Length * c.Length + c.Length * a.Length));
}

/** Whether errors turn the angle by less than 1e-15, and not to the facet's other side. */
bool HasDigits(const Arguments<Quad>& of, Quad error)
{
  const Quad enough = error * Quad(2e15);
  return of.Det * of.Det + of.Div * of.Div > enough * enough &&
    (of.Div > 0 || fabsq(of.Det) > error);
}

/** Whether all coordinates are near enough in size for Long to be exact. */
bool ExactInLong(const Site& site, const std::array<Point, 3>& corners)
{
  int low = std::numeric_limits<int>::max();
  int high = std::numeric_limits<int>::min();
  const auto add = [&](const Point& point)
  {
    for (const double x : point)
    {
      if (x != 0)
      {
        low = std::min(low, std::ilogb(x));
        high = std::max(high, std::ilogb(x));
      }
    }
  };
  std::for_each(site.Corners.begin(), site.Corners.end(), add);
  std::for_each(corners.begin(), corners.end(), add);
  return low > high || high - low < MostExponentsApart;
}

Quad ToQuad(const Long& x)
{
  const double high = static_cast<double>(x);
  return Quad(high) + static_cast<double>(x - high);
}

Quad HalfSolidAngleInLong(const Site& site, const std::array<Point, 3>& corners)
{
  if (!ExactInLong(site, corners))
  {
    return nanq("");
  }
  const VectorIn<Long> a = FromSite<Long>(site, corners[0]);
  const VectorIn<Long> b = FromSite<Long>(site, corners[1]);
  const VectorIn<Long> c = FromSite<Long>(site, corners[2]);
  const Arguments<Long> of = HalfSolidAngle(a, b, c);
  if (of.Det == 0)
  {
    return 0;
  }
  const Long lengths = a.Length * b.Length * c.Length;
  return atan2q(ToQuad(of.Det / lengths), ToQuad(of.Div / lengths));
}

/** The largest coordinate. */
Quad Size(const FacetComplex& surface, const Site& site)
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
} // namespace

double WindingNumberInQuads(const FacetComplex& surface, const Site& site)
{
  std::vector<QuadVector> vectors;
  vectors.reserve(surface.Points.size());
  for (const Point& point : surface.Points)
  {
    vectors.push_back(FromSite<Quad>(site, point));
  }
  const Quad size = Size(surface, site);
  Quad sum = 0;
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    if (surface.Multiplicity[f] == 0)
    {
      continue;
    }
    const Triangle& t = surface.Facets[f];
    const QuadVector& a = vectors[t[0]];
    const QuadVector& b = vectors[t[1]];
    const QuadVector& c = vectors[t[2]];
    const Arguments<Quad> of = HalfSolidAngle(a, b, c);
    const Quad half = HasDigits(of, ErrorOfArguments(a, b, c, size))
      ? atan2q(of.Det, of.Div)
      : HalfSolidAngleInLong(
          site, { surface.Points[t[0]], surface.Points[t[1]], surface.Points[t[2]] });
    sum += surface.Multiplicity[f] * half;
  }
  return static_cast<double>(sum / (8 * atanq(1)));
}
} // namespace testmeshes
