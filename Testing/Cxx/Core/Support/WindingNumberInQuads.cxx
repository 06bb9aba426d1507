// SPDX-License-Identifier: GPL-3.0-or-later
#include "Support/WindingNumberInQuads.h"

#include "Support/BruteForceWindingNumber.h"

#include <boost/multiprecision/mpfr.hpp>

namespace testmeshes
{
namespace
{
// Enough for determinants of three vectors, themselves of coordinates with exponents that far
// apart, as those of all doubles below 1 are.
constexpr int ManyDigits = 1085;
constexpr int MostExponentsApart = 1100;
/** At most the relative error of a sum, product or root in quadruple precision. */
constexpr double QuadEpsilon = 0x1p-112;
using Long = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<ManyDigits>,
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

/** A sum of angles as the argument of a product of complex numbers, of which the turns are counted.
 */
class AngleSum
{
public:
  /** Add `times` times the argument of div + i det, from -pi to pi; not both are 0. */
  void Add(const Arguments<Quad>& of, int times)
  {
    const double scale = std::scalbn(1.0,
      -std::ilogb(
        std::max(std::abs(static_cast<double>(of.Det)), std::abs(static_cast<double>(of.Div)))));
    const Quad det = (times < 0 ? -scale : scale) * of.Det;
    const bool isBelow = det < 0;
    const Quad div = scale * of.Div;
    for (int k = 0; k < std::abs(times); ++k)
    {
      const bool wasBelow = this->Im < 0;
      const Quad re = this->Re * div - this->Im * det;
      this->Im = this->Re * det + this->Im * div;
      this->Re = re;
      if (wasBelow == isBelow && wasBelow != (this->Im < 0))
      {
        this->Turns += wasBelow ? -1 : 1;
      }
      this->Shorten();
    }
  }

  Quad Value() const { return atan2q(this->Im, this->Re) + this->Turns * 2 * Pi(); }

private:
  void Shorten()
  {
    const double length =
      std::max(std::abs(static_cast<double>(this->Re)), std::abs(static_cast<double>(this->Im)));
    if (!(length < 1e50 && length > 1e-50))
    {
      const double scale = std::scalbn(1.0, -std::ilogb(length));
      this->Re *= scale;
      this->Im *= scale;
    }
  }

  Quad Re = 1;
  Quad Im = 0;
  std::int64_t Turns = 0;
};
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
  const Long largest = std::max(Long(abs(of.Det)), Long(abs(of.Div)));
  return atan2q(ToQuad(of.Det / largest), ToQuad(of.Div / largest));
}

double WindingNumberInQuads(const FacetComplex& surface, const Site& site)
{
  std::vector<VectorIn<Quad>> vectors;
  vectors.reserve(surface.Points.size());
  for (const Point& point : surface.Points)
  {
    vectors.push_back(FromSite<Quad>(site, point));
  }
  const double size = Size(surface, site);
  AngleSum sum;
  Quad others = 0;
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    const int multiplicity = surface.Multiplicity[f];
    if (multiplicity == 0)
    {
      continue;
    }
    const Triangle& t = surface.Facets[f];
    const VectorIn<Quad>& a = vectors[t[0]];
    const VectorIn<Quad>& b = vectors[t[1]];
    const VectorIn<Quad>& c = vectors[t[2]];
    const Arguments<Quad> of = HalfSolidAngle(a, b, c);
    const double det = std::abs(static_cast<double>(of.Det));
    const double div = static_cast<double>(of.Div);
    const double error = ErrorOfArguments(static_cast<double>(a.Length),
      static_cast<double>(b.Length), static_cast<double>(c.Length), size, QuadEpsilon);
    if (HasDigits(det, div, std::max(det, std::abs(div)), error))
    {
      sum.Add(of, multiplicity);
    }
    else
    {
      others += multiplicity * HalfSolidAngleInLong(site, CornersOf(surface, t));
    }
  }
  return static_cast<double>((sum.Value() + others) / (2 * Pi()));
}
} // namespace testmeshes
