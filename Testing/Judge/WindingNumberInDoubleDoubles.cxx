// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each number is one for each of eight sites, side by side in a vector of the processor's. There
// are no branches but for facets that lack digits at a site, which are done apart.
#include "WindingNumberInDoubleDoubles.h"

#include "Common/DoubleDouble.h"
#include "Support/BruteForceWindingNumber.h"

namespace testmeshes
{
namespace
{
typedef double Reals __attribute__((vector_size(SitesAtOnce * sizeof(double))));
using DoubleDoubles = DoubleDoubleOf<Reals>;
} // namespace
} // namespace testmeshes

namespace insideout
{
template <>
inline testmeshes::Reals FusedMultiplyAdd(
  testmeshes::Reals a, testmeshes::Reals b, testmeshes::Reals c)
{
  testmeshes::Reals result;
  for (int site = 0; site < testmeshes::SitesAtOnce; ++site)
  {
    result[site] = std::fma(a[site], b[site], c[site]);
  }
  return result;
}
} // namespace insideout

namespace testmeshes
{
namespace
{
/** The same at all sites. */
DoubleDoubles Everywhere(double x)
{
  return DoubleDoubles(Reals{} + x);
}

Reals Absolute(Reals x)
{
  return x < 0 ? -x : x;
}

Reals Larger(Reals a, Reals b)
{
  return a > b ? a : b;
}

/** One Newton step from the root of the first part. */
DoubleDoubles sqrt(const DoubleDoubles& x)
{
  Reals root;
  for (int site = 0; site < SitesAtOnce; ++site)
  {
    root[site] = std::sqrt(x.High[site]);
  }
  const DoubleDoubles rest = x - DoubleDoubles(root) * DoubleDoubles(root);
  return QuickTwoSum<Reals>(
    root, rest.High / (2 * Larger(root, Reals{} + std::numeric_limits<double>::min())));
}

/** The sites' corners, side by side. */
struct CornersOfSites
{
  explicit CornersOfSites(const std::array<Site, SitesAtOnce>& sites)
  {
    for (int site = 0; site < SitesAtOnce; ++site)
    {
      for (int k = 0; k < 4; ++k)
      {
        for (int axis = 0; axis < 3; ++axis)
        {
          this->Corners[k][axis][site] = sites[site].Corners[k][axis];
        }
      }
    }
  }

  std::array<std::array<Reals, 3>, 4> Corners;
};

VectorIn<DoubleDoubles> FromSites(const CornersOfSites& sites, const Point& point)
{
  const auto component = [&](int axis)
  {
    DoubleDoubles sum = Everywhere(4) * Everywhere(point[axis]);
    for (const auto& corner : sites.Corners)
    {
      sum -= DoubleDoubles(corner[axis]);
    }
    return sum;
  };
  VectorIn<DoubleDoubles> v = { component(0), component(1), component(2), DoubleDoubles() };
  v.Length = sqrt(v.X * v.X + v.Y * v.Y + v.Z * v.Z);
  return v;
}

/** A sum of angles at each site, as the argument of a product of complex numbers. */
class AngleSums
{
public:
  /** Add the half solid angles of a facet. @return nonzero where they lack digits: nothing added */
  auto Add(const VectorIn<DoubleDoubles>& a, const VectorIn<DoubleDoubles>& b,
    const VectorIn<DoubleDoubles>& c, double size, double sign)
  {
    const Arguments<DoubleDoubles> of = HalfSolidAngle(a, b, c);
    const Reals largest = Larger(Absolute(of.Det.High), Absolute(of.Div.High));
    const Reals error =
      ErrorOfArguments(a.Length.High, b.Length.High, c.Length.High, size, DoubleDoubleEpsilon);
    const auto has = HasDigits(Absolute(of.Det.High), of.Div.High, largest, error);
    const DoubleDoubles scale(1 / largest);
    const DoubleDoubles scaledDet = of.Det * DoubleDoubles(sign * scale.High);
    const DoubleDoubles scaledDiv = of.Div * scale;
    const Reals zero = {};
    const DoubleDoubles det(has ? scaledDet.High : zero, has ? scaledDet.Low : zero);
    const DoubleDoubles div(has ? scaledDiv.High : 1 + zero, has ? scaledDiv.Low : zero);

    const auto factorIsBelow = det.High < 0;
    const auto wasBelow = this->Im.High < 0;
    const DoubleDoubles re = this->Re * div - this->Im * det;
    const DoubleDoubles im = this->Re * det + this->Im * div;
    const auto isBelow = im.High < 0;
    const auto turned = (wasBelow == factorIsBelow) & (wasBelow != isBelow);
    this->Turns += turned ? (wasBelow ? zero - 1 : zero + 1) : zero;
    const DoubleDoubles shorten(1 / Larger(Absolute(re.High), Absolute(im.High)));
    this->Re = re * shorten;
    this->Im = im * shorten;
    return has == 0;
  }

  Quad Value(int site) const
  {
    const Quad im = Quad(this->Im.High[site]) + this->Im.Low[site];
    const Quad re = Quad(this->Re.High[site]) + this->Re.Low[site];
    return atan2q(im, re) + this->Turns[site] * 2 * Pi();
  }

private:
  DoubleDoubles Re = Everywhere(1);
  DoubleDoubles Im = Everywhere(0);
  Reals Turns = {};
};
} // namespace

std::array<double, SitesAtOnce> WindingNumbersInDoubleDoubles(
  const FacetComplex& surface, const std::array<Site, SitesAtOnce>& sites)
{
  const CornersOfSites corners(sites);
  std::vector<VectorIn<DoubleDoubles>> vectors;
  vectors.reserve(surface.Points.size());
  for (const Point& point : surface.Points)
  {
    vectors.push_back(FromSites(corners, point));
  }
  double size = 0;
  for (const Site& site : sites)
  {
    size = std::max(size, Size(surface, site));
  }
  AngleSums sums;
  std::array<Quad, SitesAtOnce> others = {};
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    const Triangle& t = surface.Facets[f];
    const double sign = surface.Multiplicity[f] < 0 ? -1 : 1;
    for (int k = 0; k < std::abs(surface.Multiplicity[f]); ++k)
    {
      const auto lacks = sums.Add(vectors[t[0]], vectors[t[1]], vectors[t[2]], size, sign);
      for (int site = 0; site < SitesAtOnce; ++site)
      {
        if (lacks[site] != 0)
        {
          others[site] += sign * HalfSolidAngleInLong(sites[site], CornersOf(surface, t));
        }
      }
    }
  }
  std::array<double, SitesAtOnce> w;
  for (int site = 0; site < SitesAtOnce; ++site)
  {
    w[site] = static_cast<double>((sums.Value(site) + others[site]) / (2 * Pi()));
  }
  return w;
}
} // namespace testmeshes
