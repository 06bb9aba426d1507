// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <cmath>
#include <vector>

/** Vectors of three numbers of any type. A Point is one of doubles. */
namespace insideout
{
template <typename Number>
using Vector = std::array<Number, 3>;

template <typename Number>
Vector<Number> Difference(const Vector<Number>& a, const Vector<Number>& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

template <typename Number>
Number Dot(const Vector<Number>& a, const Vector<Number>& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <typename Number>
Vector<Number> Cross(const Vector<Number>& a, const Vector<Number>& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

template <typename Number>
Number Determinant(const Vector<Number>& a, const Vector<Number>& b, const Vector<Number>& c)
{
  return Dot(a, Cross(b, c));
}

/** Safe if the square over- or underflows. */
inline double Length(const Point& a)
{
  return std::hypot(a[0], a[1], a[2]);
}

inline double Distance(const Point& a, const Point& b)
{
  return Length(Difference(a, b));
}

/** The midpoint of two points, rounded; symmetric. */
inline Point Midpoint(const Point& a, const Point& b)
{
  // Halves are exact, and their sum does not overflow.
  return { { a[0] / 2 + b[0] / 2, a[1] / 2 + b[1] / 2, a[2] / 2 + b[2] / 2 } };
}

/** A normal of the triangle, with twice its area as length. */
inline Point NormalOf(const Point& a, const Point& b, const Point& c)
{
  return Cross(Difference(b, a), Difference(c, a));
}

/** The cotangent of the angle at a between the directions to b and c. */
inline double CotangentAt(const Point& a, const Point& b, const Point& c)
{
  const Point toB = Difference(b, a);
  const Point toC = Difference(c, a);
  return Dot(toB, toC) / Length(Cross(toB, toC));
}

inline bool IsFinite(const Point& a)
{
  return std::isfinite(a[0]) && std::isfinite(a[1]) && std::isfinite(a[2]);
}

/** The points of a triangle or cell by its ids. */
template <std::size_t Size>
std::array<Point, Size> CornersOf(
  const std::vector<Point>& points, const std::array<Id, Size>& corners)
{
  std::array<Point, Size> result;
  for (std::size_t k = 0; k < Size; ++k)
  {
    result[k] = points[corners[k]];
  }
  return result;
}
} // namespace insideout
