// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace insideout
{
/** An axis-aligned box, boundary included. */
struct Box
{
  Point Low;
  Point High;

  /** Empty, until something is added. */
  static Box Empty()
  {
    const double infinity = std::numeric_limits<double>::infinity();
    return { { infinity, infinity, infinity }, { -infinity, -infinity, -infinity } };
  }

  double Extent(int axis) const { return this->High[axis] - this->Low[axis]; }

  /** The axis of the largest extent; on ties the first. */
  int LongestAxis() const
  {
    int longest = 0;
    for (int axis = 1; axis < 3; ++axis)
    {
      longest = this->Extent(axis) > this->Extent(longest) ? axis : longest;
    }
    return longest;
  }

  bool Holds(const Point& p) const
  {
    return this->Low[0] <= p[0] && p[0] <= this->High[0] && this->Low[1] <= p[1] &&
      p[1] <= this->High[1] && this->Low[2] <= p[2] && p[2] <= this->High[2];
  }

  bool Meets(const Box& other) const
  {
    return this->Low[0] <= other.High[0] && other.Low[0] <= this->High[0] &&
      this->Low[1] <= other.High[1] && other.Low[1] <= this->High[1] &&
      this->Low[2] <= other.High[2] && other.Low[2] <= this->High[2];
  }

  /** The box from the least to the largest coordinates of both. */
  Box Widened(double by) const
  {
    Box wide = *this;
    for (int axis = 0; axis < 3; ++axis)
    {
      wide.Low[axis] -= by;
      wide.High[axis] += by;
    }
    return wide;
  }

  void Add(const Point& point)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Low[axis] = std::min(this->Low[axis], point[axis]);
      this->High[axis] = std::max(this->High[axis], point[axis]);
    }
  }

  void Add(const Box& other)
  {
    this->Add(other.Low);
    this->Add(other.High);
  }
};

/** The bounding box of finite points; exact, because it only compares. */
inline Box BoundingBox(const std::vector<Point>& points)
{
  Box box = Box::Empty();
  for (const Point& point : points)
  {
    box.Add(point);
  }
  return box;
}

/** The bounding box of a triangle or cell. */
template <std::size_t Size>
Box BoundingBox(const std::vector<Point>& points, const std::array<Id, Size>& corners)
{
  Box box = { points[corners[0]], points[corners[0]] };
  for (std::size_t k = 1; k < Size; ++k)
  {
    box.Add(points[corners[k]]);
  }
  return box;
}
} // namespace insideout
