// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/NearestPoint.h"

#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>
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

SquaredDistances::SquaredDistances(const std::array<Point, 3>& triangle)
  : Corners(triangle)
{
  for (int k = 0; k < 3; ++k)
  {
    this->Edges[k] = Difference(triangle[(k + 1) % 3], triangle[k]);
    this->Inverses[k] = 1 / Dot(this->Edges[k], this->Edges[k]);
  }
  const Point normal = Cross(this->Edges[0], Difference(triangle[2], triangle[0]));
  const double squared = Dot(normal, normal);
  this->IsNeedle = !(squared * this->Inverses[0] * this->Inverses[2] >= LeastSquaredSine);
  for (int k = 0; k < 3; ++k)
  {
    const Point inward = Cross(normal, this->Edges[(k + 1) % 3]);
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Slopes[k][axis] = inward[axis] / squared;
    }
    this->Normal[k] = normal[k] / std::sqrt(squared);
    this->SquaredHeights[k] = squared * this->Inverses[(k + 1) % 3];
  }
}

double SquaredDistances::To(const Point& place, double most) const
{
  if (this->IsNeedle)
  {
    const Point apart = Difference(NearestPointOf(this->Corners, place), place);
    return Dot(apart, apart);
  }
  const std::array<Point, 3> from = { { Difference(place, this->Corners[0]),
    Difference(place, this->Corners[1]), Difference(place, this->Corners[2]) } };
  const double height = Dot(from[0], this->Normal);
  std::array<double, 3> coordinates;
  double bound = 0;
  for (int k = 0; k < 3; ++k)
  {
    coordinates[k] = Dot(from[(k + 1) % 3], this->Slopes[k]);
    const double beyond = std::min(coordinates[k], 0.0);
    bound = std::max(bound, beyond * beyond * this->SquaredHeights[k]);
  }
  bound += height * height;
  if (bound >= most)
  {
    return bound;
  }
  // The nearest point is on an edge that separates the place from the triangle, if any does.
  double least = std::numeric_limits<double>::infinity();
  bool isBeyond = false;
  for (int k = 0; k < 3; ++k)
  {
    if (coordinates[k] < 0)
    {
      const int i = (k + 1) % 3;
      const double t = std::clamp(Dot(from[i], this->Edges[i]) * this->Inverses[i], 0.0, 1.0);
      double squared = 0;
      for (int axis = 0; axis < 3; ++axis)
      {
        const double apart = from[i][axis] - t * this->Edges[i][axis];
        squared += apart * apart;
      }
      least = std::min(least, squared);
      isBeyond = true;
    }
  }
  return isBeyond ? least : height * height;
}
} // namespace insideout
