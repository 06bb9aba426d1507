// SPDX-License-Identifier: GPL-3.0-or-later
#include "ExactReference.h"

#include <CGAL/Exact_rational.h>

#include <algorithm>

namespace testmeshes
{
namespace
{
using Rational = CGAL::Exact_rational;
using Vector = std::array<Rational, 3>;

Vector Exact(const Point& p)
{
  return { Rational(p[0]), Rational(p[1]), Rational(p[2]) };
}

Vector Minus(const Vector& a, const Vector& b)
{
  return { Rational(a[0] - b[0]), Rational(a[1] - b[1]), Rational(a[2] - b[2]) };
}

Vector Cross(const Vector& a, const Vector& b)
{
  return { Rational(a[1] * b[2] - a[2] * b[1]), Rational(a[2] * b[0] - a[0] * b[2]),
    Rational(a[0] * b[1] - a[1] * b[0]) };
}

Rational Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** The part of a convex polygon, maybe flat to a segment or point, where (p - origin) . normal is
 * at least 0. */
std::vector<Vector> Clip(
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

/** Points whose hull is the intersection of two triangles. */
std::vector<Vector> Intersection(const std::array<Vector, 3>& a, const std::array<Vector, 3>& b)
{
  const Vector normal = Cross(Minus(b[1], b[0]), Minus(b[2], b[0]));
  const Vector opposite = Minus({ 0, 0, 0 }, normal);
  std::vector<Vector> polygon(a.begin(), a.end());
  polygon = Clip(polygon, b[0], normal);
  polygon = Clip(polygon, b[0], opposite);
  for (int k = 0; k < 3; ++k)
  {
    polygon = Clip(polygon, b[k], Cross(normal, Minus(b[(k + 1) % 3], b[k])));
  }
  return polygon;
}

bool BoxesMeet(const std::vector<Point>& points, const Triangle& a, const Triangle& b)
{
  for (int k = 0; k < 3; ++k)
  {
    const auto range = [&](const Triangle& t) {
      return std::minmax({ points[t[0]][k], points[t[1]][k], points[t[2]][k] });
    };
    const auto p = range(a);
    const auto q = range(b);
    if (p.second < q.first || q.second < p.first)
    {
      return false;
    }
  }
  return true;
}
} // namespace

bool MeetBeyondSharedByClipping(
  const std::vector<Point>& points, const Triangle& a, const Triangle& b)
{
  const auto corners = [&](const Triangle& t) {
    return std::array<Vector, 3>{ Exact(points[t[0]]), Exact(points[t[1]]), Exact(points[t[2]]) };
  };
  std::vector<Vector> shared;
  for (const Id p : a)
  {
    if (std::find(b.begin(), b.end(), p) != b.end())
    {
      shared.push_back(Exact(points[p]));
    }
  }
  for (const Vector& p : Intersection(corners(a), corners(b)))
  {
    const bool inShared = shared.size() == 1 ? p == shared[0]
      : shared.size() == 2
      ? Cross(Minus(p, shared[0]), Minus(shared[1], shared[0])) == Vector{ 0, 0, 0 }
      : false;
    if (!inShared)
    {
      return true;
    }
  }
  return false;
}

std::vector<std::array<Id, 2>> IntersectionsByClipping(
  const std::vector<Point>& points, const std::vector<Triangle>& facets)
{
  std::vector<std::array<Id, 2>> pairs;
  for (Id i = 0; i < static_cast<Id>(facets.size()); ++i)
  {
    for (Id j = i + 1; j < static_cast<Id>(facets.size()); ++j)
    {
      if (BoxesMeet(points, facets[i], facets[j]) &&
        MeetBeyondSharedByClipping(points, facets[i], facets[j]))
      {
        pairs.push_back({ i, j });
      }
    }
  }
  return pairs;
}
} // namespace testmeshes
