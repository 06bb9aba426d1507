// SPDX-License-Identifier: GPL-3.0-or-later
#include "Resolve/MeetBeyondSharedCorners.h"

#include "Common/TrianglePredicates.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace insideout
{
namespace
{
bool Apart(const std::array<int, 3>& sides)
{
  return sides[0] != 0 && sides[0] == sides[1] && sides[1] == sides[2];
}

/** The corner of `b` with the same id as corner k of `a`, None for none. */
std::array<int, 3> SharedCorners(const Triangle& a, const Triangle& b)
{
  std::array<int, 3> shared;
  for (int k = 0; k < 3; ++k)
  {
    shared[k] = a[k] == b[0] ? 0 : a[k] == b[1] ? 1 : a[k] == b[2] ? 2 : None;
  }
  return shared;
}

/**
 * Whether all corners that are not shared lie strictly on one side, so that the triangles meet
 * nowhere else.
 */
bool Apart(const std::array<int, 3>& sides, const std::array<int, 3>& shared)
{
  int low = 1;
  int high = -1;
  for (int k = 0; k < 3; ++k)
  {
    if (shared[k] == None)
    {
      low = std::min(low, sides[k]);
      high = std::max(high, sides[k]);
    }
  }
  return low == high && low != 0;
}

/** SidesOfPlane, except that a shared corner counts as on the plane without a predicate. */
std::array<int, 3> SidesOfPlane(const FilteredTriangle& triangle, const FilteredTriangle& other,
  const std::array<int, 3>& sharedOfOther)
{
  std::array<int, 3> sides{ { 0, 0, 0 } };
  for (int k = 0; k < 3; ++k)
  {
    if (sharedOfOther[k] == None)
    {
      sides[k] = CGAL::orientation(triangle[0], triangle[1], triangle[2], other[k]);
    }
  }
  return sides;
}

/**
 * Whether a segment and a triangle of one plane meet: they do unless the line of one of the four
 * edges separates them.
 */
bool SegmentMeetsInPlane(
  const FilteredPoint& p, const FilteredPoint& q, const FilteredTriangle& triangle)
{
  const int axis = ProjectionAxis(triangle);
  const ProjectedTriangle image = Project(triangle, axis);
  const ProjectedPoint first = Project(p, axis);
  const ProjectedPoint last = Project(q, axis);
  const CGAL::Orientation outside = -CGAL::orientation(image[0], image[1], image[2]);
  for (int k = 0; k < 3; ++k)
  {
    if (CGAL::orientation(image[k], image[(k + 1) % 3], first) == outside &&
      CGAL::orientation(image[k], image[(k + 1) % 3], last) == outside)
    {
      return false;
    }
  }
  return !Apart({ CGAL::orientation(first, last, image[0]),
    CGAL::orientation(first, last, image[1]), CGAL::orientation(first, last, image[2]) });
}

/**
 * Whether the segment from p to q, whose ends lie on these sides of the triangle's plane, meets the
 * triangle.
 */
bool SegmentMeets(const FilteredPoint& p, int sideOfP, const FilteredPoint& q, int sideOfQ,
  const FilteredTriangle& triangle)
{
  if (sideOfP * sideOfQ > 0)
  {
    return false;
  }
  if (sideOfP != 0 && sideOfQ != 0)
  {
    return Pierces(p, q, triangle);
  }
  if (sideOfP == 0 && sideOfQ == 0)
  {
    return SegmentMeetsInPlane(p, q, triangle);
  }
  return ContainsInPlane(triangle, sideOfP == 0 ? p : q);
}

/**
 * Whether an edge of `a` meets `b`; `sides` are those of a's corners. Edges at a shared corner are
 * skipped: any further intersection extends from that corner to the opposite edge of one of the
 * triangles.
 */
bool EdgeMeets(const FilteredTriangle& a, const std::array<int, 3>& sides,
  const std::array<int, 3>& shared, const FilteredTriangle& b)
{
  for (int k = 0; k < 3; ++k)
  {
    const int next = (k + 1) % 3;
    if (shared[k] == None && shared[next] == None &&
      SegmentMeets(a[k], sides[k], a[next], sides[next], b))
    {
      return true;
    }
  }
  return false;
}

/** The corners of a triangle, by their coordinates. */
class CornersInPlace
{
public:
  CornersInPlace(const std::vector<Point>& points, const Triangle& triangle)
    : Corners{ { &points[triangle[0]], &points[triangle[1]], &points[triangle[2]] } }
  {
  }

  CornersInPlace(const std::array<Point, 3>& places)
    : Corners{ { &places[0], &places[1], &places[2] } }
  {
  }

  const Point& operator[](int k) const { return *this->Corners[k]; }

  FilteredTriangle ToFiltered() const
  {
    return { { insideout::ToFiltered(*this->Corners[0]), insideout::ToFiltered(*this->Corners[1]),
      insideout::ToFiltered(*this->Corners[2]) } };
  }

private:
  std::array<const Point*, 3> Corners;
};

/** A floating-point value and a bound of its error. */
struct Estimate
{
  double Value;
  double Error;
};

/**
 * Bound, relative to the terms, far above the rounding errors of a few operations; and the limit of
 * underflow.
 */
constexpr double RelativeError = 16 * std::numeric_limits<double>::epsilon();
constexpr double Underflow = 16 * std::numeric_limits<double>::min();

/** The component of p - origin along a direction. */
Estimate Along(const std::array<double, 3>& direction, const Point& origin, const Point& p)
{
  const double x = direction[0] * (p[0] - origin[0]);
  const double y = direction[1] * (p[1] - origin[1]);
  const double z = direction[2] * (p[2] - origin[2]);
  return { x + y + z, RelativeError * (std::abs(x) + std::abs(y) + std::abs(z)) + Underflow };
}

/**
 * Whether all corners of `b` lie certainly on one side of the plane of `a`.
 * This decides on most pairs of needles, whose boxes meet many others, before any predicate.
 */
bool ClearlyOnOneSide(const CornersInPlace& a, const CornersInPlace& b)
{
  const Point u = Difference(a[1], a[0]);
  const Point v = Difference(a[2], a[0]);
  std::array<Estimate, 3> normal;
  for (int k = 0; k < 3; ++k)
  {
    const double left = u[(k + 1) % 3] * v[(k + 2) % 3];
    const double right = u[(k + 2) % 3] * v[(k + 1) % 3];
    normal[k] = { left - right, RelativeError * (std::abs(left) + std::abs(right)) + Underflow };
  }
  int side = 0;
  for (int i = 0; i < 3; ++i)
  {
    double height = 0;
    double error = Underflow;
    for (int k = 0; k < 3; ++k)
    {
      const double along = b[i][k] - a[0][k];
      height += normal[k].Value * along;
      error += normal[k].Error * std::abs(along);
    }
    const int here = (height > error) - (height < -error);
    if (!std::isfinite(height) || here == 0 || here == -side) // the sum may have overflowed
    {
      return false;
    }
    side = here;
  }
  return true;
}

/** The vector from a point to the center of a triangle, three times as long. */
Point TowardCenter(const Point& from, const CornersInPlace& triangle)
{
  Point sum{};
  for (int k = 0; k < 3; ++k)
  {
    const Point more = Difference(triangle[k], from);
    sum = { sum[0] + more[0], sum[1] + more[1], sum[2] + more[2] };
  }
  return sum;
}

/**
 * Whether triangles with at most one shared corner are certainly apart beyond it. A plane through
 * that corner, which halves the angle between the directions to their centers, then separates them;
 * without a shared corner one across the line between the centers. This spares coplanar neighbors
 * the exact arithmetic. NaN after overflow compares as false, which is safe.
 */
bool ClearlyApart(const CornersInPlace& a, const std::array<int, 3>& sharedOfA,
  const CornersInPlace& b, const std::array<int, 3>& sharedOfB)
{
  const auto corner =
    std::find_if(sharedOfA.begin(), sharedOfA.end(), [](int other) { return other != None; });
  const bool through = corner != sharedOfA.end();
  const Point* const origin = &a[through ? static_cast<int>(corner - sharedOfA.begin()) : 0];
  const Point toA = TowardCenter(*origin, a);
  const Point toB = TowardCenter(*origin, b);
  const double weightOfA = through ? std::sqrt(Dot(toB, toB)) : 1;
  const double weightOfB = through ? std::sqrt(Dot(toA, toA)) : 1;
  Point direction;
  for (int axis = 0; axis < 3; ++axis)
  {
    direction[axis] = weightOfA * toA[axis] - weightOfB * toB[axis];
  }
  std::array<Estimate, 3> ofB;
  for (int k = 0; k < 3; ++k)
  {
    ofB[k] = Along(direction, *origin, b[k]);
    if (through && sharedOfB[k] == None && !(ofB[k].Value < -ofB[k].Error))
    {
      return false;
    }
  }
  for (int k = 0; k < 3; ++k)
  {
    if (sharedOfA[k] != None)
    {
      continue;
    }
    const Estimate ofA = Along(direction, *origin, a[k]);
    for (int i = 0; i < 3; ++i)
    {
      if (!(ofA.Value - ofA.Error > ofB[i].Value + ofB[i].Error))
      {
        return false;
      }
    }
  }
  return true;
}

/**
 * Whether triangles with a common edge lie certainly on different sides of its line, seen along an
 * axis.
 */
bool ClearlyOnEitherSide(const Point& p, const Point& q, const Point& r, const Point& s)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const double along[2] = { q[u] - p[u], q[v] - p[v] };
    const auto side = [&](const Point& t) -> Estimate
    {
      const double left = along[0] * (t[v] - p[v]);
      const double right = along[1] * (t[u] - p[u]);
      return { left - right, RelativeError * (std::abs(left) + std::abs(right)) + Underflow };
    };
    const Estimate ofR = side(r);
    const Estimate ofS = side(s);
    if ((ofR.Value > ofR.Error && ofS.Value < -ofS.Error) ||
      (ofR.Value < -ofR.Error && ofS.Value > ofS.Error))
    {
      return true;
    }
  }
  return false;
}

bool Meet(const Triangle& a, const CornersInPlace& placesOfA, const Triangle& b,
  const CornersInPlace& placesOfB)
{
  const std::array<int, 3> sharedOfA = SharedCorners(a, b);
  const std::array<int, 3> sharedOfB = SharedCorners(b, a);
  const int shared = (sharedOfA[0] != None) + (sharedOfA[1] != None) + (sharedOfA[2] != None);
  if (shared == 2)
  {
    const int apexOfA =
      static_cast<int>(std::find(sharedOfA.begin(), sharedOfA.end(), None) - sharedOfA.begin());
    const int apexOfB =
      static_cast<int>(std::find(sharedOfB.begin(), sharedOfB.end(), None) - sharedOfB.begin());
    if (ClearlyOnEitherSide(placesOfA[(apexOfA + 1) % 3], placesOfA[(apexOfA + 2) % 3],
          placesOfA[apexOfA], placesOfB[apexOfB]))
    {
      return false;
    }
    // In two planes they have only the edge in common, too.
    const FilteredTriangle p = placesOfA.ToFiltered();
    const FilteredTriangle q = placesOfB.ToFiltered();
    return CGAL::coplanar(p[0], p[1], p[2], q[apexOfB]) && OverlapInPlane(p, q);
  }
  if ((shared == 0 &&
        (ClearlyOnOneSide(placesOfA, placesOfB) || ClearlyOnOneSide(placesOfB, placesOfA))) ||
    ClearlyApart(placesOfA, sharedOfA, placesOfB, sharedOfB))
  {
    return false;
  }
  const FilteredTriangle p = placesOfA.ToFiltered();
  const FilteredTriangle q = placesOfB.ToFiltered();
  const std::array<int, 3> sidesOfB = SidesOfPlane(p, q, sharedOfB);
  const bool coplanar = sidesOfB[0] == 0 && sidesOfB[1] == 0 && sidesOfB[2] == 0;
  if (Apart(sidesOfB, sharedOfB))
  {
    return false;
  }
  const std::array<int, 3> sidesOfA =
    coplanar ? std::array<int, 3>{ { 0, 0, 0 } } : SidesOfPlane(q, p, sharedOfA);
  if (Apart(sidesOfA, sharedOfA))
  {
    return false;
  }
  return EdgeMeets(p, sidesOfA, sharedOfA, q) || EdgeMeets(q, sidesOfB, sharedOfB, p);
}
} // namespace

bool MeetBeyondSharedCorners(const std::vector<Point>& points, const Triangle& a, const Triangle& b)
{
  return Meet(a, { points, a }, b, { points, b });
}

bool MeetBeyondSharedCorners(const Triangle& a, const std::array<Point, 3>& placesOfA,
  const Triangle& b, const std::array<Point, 3>& placesOfB)
{
  return Meet(a, placesOfA, b, placesOfB);
}
} // namespace insideout
