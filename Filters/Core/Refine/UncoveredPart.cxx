// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/UncoveredPart.h"

#include "Common/NearestPoint.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace insideout
{
namespace
{
using Polygon = std::vector<Point>;

Point Scaled(const Point& v, double factor)
{
  return { { factor * v[0], factor * v[1], factor * v[2] } };
}

/** Twice the signed area of a triangle in the plane, negative if clockwise. */
double AreaInPlane(const Point& a, const Point& b, const Point& c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/** The parts of a convex polygon left and right of a line. */
void Cut(const Polygon& polygon, const Point& from, const Point& to, Polygon& left, Polygon& right)
{
  left.clear();
  right.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point& here = polygon[i];
    const Point& next = polygon[(i + 1) % polygon.size()];
    const double sideHere = AreaInPlane(from, to, here);
    const double sideNext = AreaInPlane(from, to, next);
    if (sideHere >= 0)
    {
      left.push_back(here);
    }
    if (sideHere <= 0)
    {
      right.push_back(here);
    }
    if ((sideHere > 0 && sideNext < 0) || (sideHere < 0 && sideNext > 0))
    {
      const double t = sideHere / (sideHere - sideNext);
      left.push_back(
        { { here[0] + t * (next[0] - here[0]), here[1] + t * (next[1] - here[1]), 0 } });
      right.push_back(left.back());
    }
  }
}

/** Whether all of a convex polygon is near a triangle: distances from a triangle are convex. */
bool IsNear(
  const Polygon& polygon, const std::array<Point, 3>& triangle, const Box& reach, double near)
{
  // The cheapest tests come first: hardly any polygon passes.
  return std::all_of(polygon.begin(), polygon.end(),
           [&](const Point& corner) { return reach.Holds(corner); }) &&
    std::all_of(polygon.begin(), polygon.end(),
      [&](const Point& corner)
      {
        const Point apart = Difference(NearestPointOf(triangle, corner), corner);
        return Dot(apart, apart) <= near * near;
      });
}

/** The height of a triangle's plane above a place of this plane. */
double HeightOver(const std::array<Point, 3>& triangle, double area, const Point& place)
{
  const auto& [a, b, c] = triangle;
  return (AreaInPlane(place, b, c) * a[2] + AreaInPlane(a, place, c) * b[2] +
           AreaInPlane(a, b, place) * c[2]) /
    area;
}
} // namespace

UncoveredPart::UncoveredPart(const std::array<Point, 3>& triangle, double distance)
  : Origin(triangle[0])
  , Near(distance)
{
  const Point along = Difference(triangle[1], triangle[0]);
  const Point normal = NormalOf(triangle[0], triangle[1], triangle[2]);
  this->HasNormal = Length(normal) > 0;
  if (this->HasNormal)
  {
    this->Axes[0] = Scaled(along, 1 / Length(along));
    this->Axes[2] = Scaled(normal, 1 / Length(normal));
    this->Axes[1] = Cross(this->Axes[2], this->Axes[0]);
    this->Parts.emplace_back();
    for (const Point& corner : triangle)
    {
      const Point place = this->ToPlane(corner);
      this->Parts.back().push_back({ { place[0], place[1], 0 } });
    }
  }
}

Point UncoveredPart::ToPlane(const Point& place) const
{
  const Point from = Difference(place, this->Origin);
  return { { Dot(from, this->Axes[0]), Dot(from, this->Axes[1]), Dot(from, this->Axes[2]) } };
}

/**
 * Whether all or a part of it is covered. In that case Left gets the rest: the pieces beyond each
 * edge of the triangle.
 */
bool UncoveredPart::CoverPart(
  const Polygon& part, const std::array<Point, 3>& near, const Box& reach)
{
  this->Left.clear();
  if (!BoundingBox(part).Meets(reach))
  {
    return false;
  }
  if (IsNear(part, near, reach, this->Near))
  {
    return true;
  }
  const double area = AreaInPlane(near[0], near[1], near[2]);
  auto& [over, within, beyond] = this->Cuts;
  over = part;
  for (int k = 0; k < 3 && over.size() > 2; ++k)
  {
    Cut(over, near[k], near[(k + 1) % 3], within, beyond);
    if (beyond.size() > 2 && !IsNear(beyond, near, reach, this->Near))
    {
      this->Left.push_back(beyond);
    }
    over.swap(within);
  }
  return area > 0 && over.size() > 2 &&
    std::all_of(over.begin(), over.end(),
      [&](const Point& place) { return std::abs(HeightOver(near, area, place)) <= this->Near; });
}

void UncoveredPart::Cover(const std::array<Point, 3>& near)
{
  std::array<Point, 3> there = { { this->ToPlane(near[0]), this->ToPlane(near[1]),
    this->ToPlane(near[2]) } };
  if (AreaInPlane(there[0], there[1], there[2]) < 0)
  {
    std::swap(there[1], there[2]);
  }
  const Box reach = BoundingBox({ there.begin(), there.end() }).Widened(this->Near);
  // Most triangles reach few parts: the others stay where they are.
  for (std::size_t i = this->Parts.size(); i-- > 0;)
  {
    if (this->CoverPart(this->Parts[i], there, reach))
    {
      this->Parts[i].swap(this->Parts.back());
      this->Parts.pop_back();
      std::move(this->Left.begin(), this->Left.end(), std::back_inserter(this->Parts));
    }
  }
}
} // namespace insideout
