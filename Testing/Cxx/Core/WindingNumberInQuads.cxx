// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumberInQuads.h"

#include "BruteForceWindingNumber.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace testmeshes
{
namespace
{
// Enough for determinants of three vectors, themselves of coordinates with exponents that far
// apart.
constexpr int ManyBits = 1200;
constexpr int MostExponentsApart = 250;
using Long = boost::multiprecision::number<
  boost::multiprecision::cpp_bin_float<ManyBits, boost::multiprecision::digit_base_2>,
  boost::multiprecision::et_off>;

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
} // namespace

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

double WindingNumberInQuads(const FacetComplex& surface, const Site& site)
{
  return BruteForceWindingNumber<Quad>(surface, site, 0x1p-112);
}
} // namespace testmeshes
