// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumberInQuads.h"

#include <quadmath.h>

namespace testmeshes
{
using namespace insideout;

namespace
{
__extension__ typedef __float128 Quad;

/** From the site to a point, times 4, and its length. */
struct QuadVector
{
  Quad X, Y, Z, Length;
};

QuadVector FromSite(const Site& site, const Point& point)
{
  const auto component = [&](int axis)
  {
    Quad sum = Quad(4) * point[axis];
    for (const Point& corner : site.Corners)
    {
      sum -= corner[axis];
    }
    return sum;
  };
  QuadVector v = { component(0), component(1), component(2), 0 };
  v.Length = sqrtq(v.X * v.X + v.Y * v.Y + v.Z * v.Z);
  return v;
}

Quad Dot(const QuadVector& a, const QuadVector& b)
{
  return a.X * b.X + a.Y * b.Y + a.Z * b.Z;
}

/** Van Oosterom and Strackee 1983, equation 8. */
Quad HalfSolidAngle(const QuadVector& a, const QuadVector& b, const QuadVector& c)
{
  const Quad det =
    a.X * (b.Y * c.Z - b.Z * c.Y) + a.Y * (b.Z * c.X - b.X * c.Z) + a.Z * (b.X * c.Y - b.Y * c.X);
  if (det == 0)
  {
    return 0;
  }
  return atan2q(det,
    a.Length * b.Length * c.Length + Dot(a, b) * c.Length + Dot(b, c) * a.Length +
      Dot(c, a) * b.Length);
}
} // namespace

double WindingNumberInQuads(const FacetComplex& surface, const Site& site)
{
  std::vector<QuadVector> vectors;
  vectors.reserve(surface.Points.size());
  for (const Point& point : surface.Points)
  {
    vectors.push_back(FromSite(site, point));
  }
  Quad sum = 0;
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    const Triangle& t = surface.Facets[f];
    if (surface.Multiplicity[f] != 0)
    {
      sum += surface.Multiplicity[f] * HalfSolidAngle(vectors[t[0]], vectors[t[1]], vectors[t[2]]);
    }
  }
  return static_cast<double>(sum / (8 * atanq(1)));
}
} // namespace testmeshes
