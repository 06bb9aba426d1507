// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/NearestPoint.h"

#include "Common/Vectors.h"

#include <algorithm>
#include <limits>

namespace insideout
{
namespace
{
// Doubles do not determine a needle's normal well: triangles with a squared sine at a corner below
// this are handled in long doubles.
constexpr double LeastSquaredSine = 0x1p-16;

template <typename Number>
Vector<Number> NearestPointOfSegment(const Vector<Number>& a, const Vector<Number>& b)
{
  const Vector<Number> along = insideout::Difference(b, a);
  const Number squared = Dot(along, along);
  const Number t = squared > 0 ? std::clamp<Number>(-Dot(a, along) / squared, 0, 1) : 0;
  return { a[0] + t * along[0], a[1] + t * along[1], a[2] + t * along[2] };
}

/** The point of the outline nearest to 0. */
template <typename Number>
Vector<Number> NearestPointOfOutline(const std::array<Vector<Number>, 3>& triangle)
{
  Vector<Number> nearest = triangle[0];
  Number least = std::numeric_limits<Number>::infinity();
  for (int k = 0; k < 3; ++k)
  {
    const Vector<Number> there = NearestPointOfSegment(triangle[k], triangle[(k + 1) % 3]);
    const Number squared = Dot(there, there);
    if (squared < least)
    {
      least = squared;
      nearest = there;
    }
  }
  return nearest;
}

/** The point nearest to 0; or sets `isNeedle` instead. */
template <typename Number>
Vector<Number> NearestPointTo0(const std::array<Vector<Number>, 3>& triangle, bool* isNeedle)
{
  const auto& [a, b, c] = triangle;
  const Vector<Number> ab = Difference(b, a);
  const Vector<Number> ac = Difference(c, a);
  const Vector<Number> normal = Cross(ab, ac);
  const Number squared = Dot(normal, normal);
  if (isNeedle && squared < LeastSquaredSine * Dot(ab, ab) * Dot(ac, ac))
  {
    *isNeedle = true;
    return a;
  }
  if (squared > 0)
  {
    // Barycentric coordinates of 0's projection, times `squared`.
    const Number ofC = Dot(Cross(a, ab), normal);
    const Number ofB = Dot(Cross(ac, a), normal);
    if (ofB >= 0 && ofC >= 0 && ofB + ofC <= squared)
    {
      const Number height = Dot(a, normal) / squared;
      return { height * normal[0], height * normal[1], height * normal[2] };
    }
  }
  return NearestPointOfOutline(triangle);
}

template <typename Number>
std::array<Vector<Number>, 3> SeenFrom(const Point& place, const std::array<Point, 3>& triangle)
{
  std::array<Vector<Number>, 3> seen;
  for (int k = 0; k < 3; ++k)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      seen[k][axis] = Number(triangle[k][axis]) - Number(place[axis]);
    }
  }
  return seen;
}

template <typename Number>
Point MovedBy(const Point& place, const Vector<Number>& d)
{
  Point moved;
  for (int axis = 0; axis < 3; ++axis)
  {
    moved[axis] = static_cast<double>(Number(place[axis]) + d[axis]);
  }
  return moved;
}
} // namespace

Point NearestPointOf(const std::array<Point, 3>& triangle, const Point& place)
{
  bool isNeedle = false;
  const Point nearest = NearestPointTo0(SeenFrom<double>(place, triangle), &isNeedle);
  return !isNeedle
    ? MovedBy(place, nearest)
    : MovedBy(place, NearestPointTo0(SeenFrom<long double>(place, triangle), nullptr));
}
} // namespace insideout
