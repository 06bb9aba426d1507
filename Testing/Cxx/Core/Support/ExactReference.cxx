// SPDX-License-Identifier: GPL-3.0-or-later
#include "Support/ExactReference.h"

#include "Support/RationalVectors.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace testmeshes
{
namespace
{
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

bool LiesWithinByClipping(const std::vector<Point>& points, const Triangle& t, Id point)
{
  const Vector p = Exact(points[point]);
  const std::array<Vector, 3> corners = { Exact(points[t[0]]), Exact(points[t[1]]),
    Exact(points[t[2]]) };
  const Vector normal = Cross(Minus(corners[1], corners[0]), Minus(corners[2], corners[0]));
  bool within = Dot(Minus(p, corners[0]), normal) == 0;
  for (int k = 0; within && k < 3; ++k)
  {
    const Vector along = Minus(corners[(k + 1) % 3], corners[k]);
    within = p != corners[k] && Dot(Minus(p, corners[k]), Cross(normal, along)) >= 0;
  }
  return within;
}

namespace
{
using Filtered = CGAL::Exact_predicates_inexact_constructions_kernel;
using FilteredPoint = Filtered::Point_3;
using Corners = std::array<Point, 3>;

FilteredPoint ToCgal(const Point& p)
{
  return { p[0], p[1], p[2] };
}

/** The sign of det(b - a, c - a, d - a). */
int Orientation(const Point& a, const Point& b, const Point& c, const Point& d)
{
  return CGAL::orientation(ToCgal(a), ToCgal(b), ToCgal(c), ToCgal(d));
}

/** The sign of the area of a, b, c in the plane that `axis` is left out of. */
int OrientationAlong(int axis, const Point& a, const Point& b, const Point& c)
{
  const int x = (axis + 1) % 3;
  const int y = (axis + 2) % 3;
  using P = Filtered::Point_2;
  return CGAL::orientation(P(a[x], a[y]), P(b[x], b[y]), P(c[x], c[y]));
}

/** An axis along which the triangle keeps an area. */
int AxisAcross(const Corners& t)
{
  int axis = 0;
  while (axis < 2 && OrientationAlong(axis, t[0], t[1], t[2]) == 0)
  {
    ++axis;
  }
  return axis;
}

Corners CornersOf(const std::vector<Point>& points, const Triangle& t)
{
  return { points[t[0]], points[t[1]], points[t[2]] };
}

/** The corners in their cyclic order, beginning with number `first`. */
Corners Turned(const Corners& t, int first)
{
  return { t[first], t[(first + 1) % 3], t[(first + 2) % 3] };
}

/** Whether x, in the plane of `t`, is in the closed cone at corner 0. */
bool InCone(const Corners& t, const Point& x)
{
  const int axis = AxisAcross(t);
  const int turn = OrientationAlong(axis, t[0], t[1], t[2]);
  return OrientationAlong(axis, t[0], t[1], x) * turn >= 0 &&
    OrientationAlong(axis, t[0], x, t[2]) * turn >= 0;
}

/**
 * Whether two triangles with one common corner, first in both, meet elsewhere. They do exactly when
 * their cones at that corner have a ray in common, for triangles are convex.
 */
bool MeetBesideCorner(const Corners& a, const Corners& b)
{
  const int sideR = Orientation(a[0], a[1], a[2], b[1]);
  const int sideS = Orientation(a[0], a[1], a[2], b[2]);
  if (sideR * sideS > 0)
  {
    return false;
  }
  if (sideR == 0 && sideS == 0)
  {
    return InCone(a, b[1]) || InCone(a, b[2]) || InCone(b, a[1]) || InCone(b, a[2]);
  }
  if (sideR == 0 || sideS == 0)
  {
    return InCone(a, sideR == 0 ? b[1] : b[2]);
  }
  // The ray of b in the plane of a is lambda (a1 - a0) + mu (a2 - a0); these are the signs.
  const int mu = Orientation(a[0], a[1], b[1], b[2]) * sideS;
  const int lambda = Orientation(a[0], b[1], a[2], b[2]) * sideS;
  return lambda >= 0 && mu >= 0;
}

/** Whether two triangles on the edge from corner 0 to 1 of `a`, with `apex` the third corner of the
 * other one, are folded onto each other. */
bool MeetBesideEdge(const Corners& a, const Point& apex)
{
  if (Orientation(a[0], a[1], a[2], apex) != 0)
  {
    return false;
  }
  const int axis = AxisAcross(a);
  return OrientationAlong(axis, a[0], a[1], a[2]) == OrientationAlong(axis, a[0], a[1], apex);
}

/**
 * Whether a plane across `axis`, any vector, separates two triangles by more than the rounding
 * errors of what is computed here.
 */
bool SeparatedAlong(const Point& axis, const Corners& a, const Corners& b)
{
  double magnitude = 0;
  const auto range = [&](const Corners& t)
  {
    std::array<double, 2> bounds = { std::numeric_limits<double>::infinity(),
      -std::numeric_limits<double>::infinity() };
    for (const Point& p : t)
    {
      double sum = 0;
      double sumOfSizes = 0;
      for (int k = 0; k < 3; ++k)
      {
        const double term = axis[k] * (p[k] - a[0][k]);
        sum += term;
        sumOfSizes += std::abs(term);
      }
      bounds = { std::min(bounds[0], sum), std::max(bounds[1], sum) };
      magnitude = std::max(magnitude, sumOfSizes);
    }
    return bounds;
  };
  const auto ofA = range(a);
  const auto ofB = range(b);
  // A difference, a product and two sums: less than five roundings in each of two numbers.
  const double error =
    10 * std::numeric_limits<double>::epsilon() * magnitude + std::numeric_limits<double>::min();
  return ofB[0] - ofA[1] > error || ofA[0] - ofB[1] > error;
}

/** Quickly and safely true for most triangles that are apart; false says nothing. */
bool SurelyApart(const Corners& a, const Corners& b)
{
  const auto edge = [](const Corners& t, int k)
  {
    const Point& p = t[k];
    const Point& q = t[(k + 1) % 3];
    return Point{ q[0] - p[0], q[1] - p[1], q[2] - p[2] };
  };
  const auto cross = [](const Point& u, const Point& v)
  {
    return Point{ u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0] };
  };
  const Point normalA = cross(edge(a, 0), edge(a, 1));
  const Point normalB = cross(edge(b, 0), edge(b, 1));
  if (SeparatedAlong(normalA, a, b) || SeparatedAlong(normalB, a, b))
  {
    return true;
  }
  for (int i = 0; i < 3; ++i)
  {
    if (SeparatedAlong(cross(normalA, edge(a, i)), a, b) ||
      SeparatedAlong(cross(normalB, edge(b, i)), a, b))
    {
      return true;
    }
    for (int j = 0; j < 3; ++j)
    {
      if (SeparatedAlong(cross(edge(a, i), edge(b, j)), a, b))
      {
        return true;
      }
    }
  }
  return false;
}

bool MeetSharingNothing(const Corners& a, const Corners& b)
{
  const auto triangle = [](const Corners& t)
  { return Filtered::Triangle_3(ToCgal(t[0]), ToCgal(t[1]), ToCgal(t[2])); };
  return !SurelyApart(a, b) && CGAL::do_intersect(triangle(a), triangle(b));
}
} // namespace

bool MeetBeyondSharedByOrientation(
  const std::vector<Point>& points, const Triangle& a, const Triangle& b)
{
  std::array<int, 3> placeInB = { None, None, None };
  int shared = 0;
  for (int k = 0; k < 3; ++k)
  {
    const auto place = std::find(b.begin(), b.end(), a[k]);
    if (place != b.end())
    {
      placeInB[k] = static_cast<int>(place - b.begin());
      ++shared;
    }
  }
  const Corners cornersA = CornersOf(points, a);
  const Corners cornersB = CornersOf(points, b);
  if (shared == 0)
  {
    return MeetSharingNothing(cornersA, cornersB);
  }
  if (shared == 1)
  {
    const int k = static_cast<int>(
      std::find_if(placeInB.begin(), placeInB.end(), [](int i) { return i != None; }) -
      placeInB.begin());
    return MeetBesideCorner(Turned(cornersA, k), Turned(cornersB, placeInB[k]));
  }
  if (shared == 2)
  {
    const int lone =
      static_cast<int>(std::find(placeInB.begin(), placeInB.end(), None) - placeInB.begin());
    const int apex = 3 - placeInB[(lone + 1) % 3] - placeInB[(lone + 2) % 3];
    return MeetBesideEdge(Turned(cornersA, (lone + 1) % 3), cornersB[apex]);
  }
  return true;
}

std::vector<std::array<Id, 2>> IntersectionsBySweep(
  const std::vector<Point>& points, const std::vector<Triangle>& facets)
{
  using Pairs = std::vector<std::array<Id, 2>>;
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, Id>;
  std::vector<Box> boxes;
  for (Id f = 0; f < static_cast<Id>(facets.size()); ++f)
  {
    CGAL::Bbox_3 bounds;
    for (const Id p : facets[f])
    {
      bounds += ToCgal(points[p]).bbox();
    }
    boxes.emplace_back(bounds, f);
  }
  Pairs found;
  Pairs candidates;
  const auto decide = [&]
  {
#pragma omp parallel
    {
      Pairs mine;
#pragma omp for schedule(dynamic, 256)
      for (std::size_t i = 0; i < candidates.size(); ++i)
      {
        const auto& pair = candidates[i];
        if (MeetBeyondSharedByOrientation(points, facets[pair[0]], facets[pair[1]]))
        {
          mine.push_back(pair);
        }
      }
#pragma omp critical(InsideOutReferencePairs)
      found.insert(found.end(), mine.begin(), mine.end());
    }
    candidates.clear();
  };
  constexpr std::size_t batch = 1 << 20;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(),
    [&](const Box& a, const Box& b)
    {
      candidates.push_back({ std::min(a.info(), b.info()), std::max(a.info(), b.info()) });
      if (candidates.size() == batch)
      {
        decide();
      }
    });
  decide();
  std::sort(found.begin(), found.end());
  return found;
}
} // namespace testmeshes
