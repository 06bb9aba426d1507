// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <CGAL/Exact_rational.h>

#include <vector>

/** Vectors and convex polygons in rational numbers: slow, and right straight from the definition.
 */
namespace testmeshes
{
using insideout::Point;

using Rational = CGAL::Exact_rational;
using Vector = std::array<Rational, 3>;

inline Vector Exact(const Point& p)
{
  return { Rational(p[0]), Rational(p[1]), Rational(p[2]) };
}

inline Vector Minus(const Vector& a, const Vector& b)
{
  return { Rational(a[0] - b[0]), Rational(a[1] - b[1]), Rational(a[2] - b[2]) };
}

inline Vector Cross(const Vector& a, const Vector& b)
{
  return { Rational(a[1] * b[2] - a[2] * b[1]), Rational(a[2] * b[0] - a[0] * b[2]),
    Rational(a[0] * b[1] - a[1] * b[0]) };
}

inline Rational Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** The part of a convex polygon, maybe flat to a segment or point, where (p - origin) . normal is
 * at least 0. */
inline std::vector<Vector> Clip(
  const std::vector<Vector>& polygon, const Vector& origin, const Vector& normal)
{
  std::vector<Vector> clipped;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Vector& p = polygon[i];
    const Vector& q = polygon[(i + 1) % polygon.size()];
    const Rational atP = Dot(Minus(p, origin), normal);
    const Rational atQ = Dot(Minus(q, origin), normal);
    if (atP >= 0)
    {
      clipped.push_back(p);
    }
    if ((atP < 0 && atQ > 0) || (atP > 0 && atQ < 0))
    {
      const Rational t = atP / (atP - atQ);
      clipped.push_back({ Rational(p[0] + t * (q[0] - p[0])), Rational(p[1] + t * (q[1] - p[1])),
        Rational(p[2] + t * (q[2] - p[2])) });
    }
  }
  return clipped;
}
} // namespace testmeshes
