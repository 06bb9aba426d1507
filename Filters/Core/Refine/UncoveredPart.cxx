// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/UncoveredPart.h"

#include "Common/NearestPoint.h"
#include "Common/SignOfDeterminant.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace insideout
{
namespace
{
/** Distances in the plane below this fraction of the largest coordinate are rounding errors. */
constexpr double Rounding = 32 * DoubleEpsilon;

Point Scaled(const Point& v, double factor)
{
  return { { factor * v[0], factor * v[1], factor * v[2] } };
}

PlanarPoint Flat(const Point& place)
{
  return { { place[0], place[1] } };
}

/** Twice the signed area of a triangle in the plane, negative if clockwise. */
double AreaInPlane(const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}
} // namespace

UncoveredPart::Polygon& UncoveredPart::Polygon::operator=(const Polygon& other)
{
  this->Size = other.Size;
  this->Low = other.Low;
  this->High = other.High;
  std::copy_n(other.Corners.begin(), other.Size, this->Corners.begin());
  return *this;
}

void UncoveredPart::Polygon::FindBox()
{
  this->Low = this->Corners[0];
  this->High = this->Corners[0];
  for (int i = 1; i < this->Size; ++i)
  {
    for (int axis = 0; axis < 2; ++axis)
    {
      this->Low[axis] = std::min(this->Low[axis], this->Corners[i][axis]);
      this->High[axis] = std::max(this->High[axis], this->Corners[i][axis]);
    }
  }
}

/** A triangle of the surface, by two coordinates in the plane and the height above it. */
class UncoveredPart::NearTriangle
{
public:
  /** @param[in] size the largest coordinate of polygons in the plane */
  NearTriangle(const std::array<Point, 3>& corners, double near, double size)
    : Corners(corners)
    , Near(near)
    , Reach{ corners[0], corners[0] }
  {
    this->Reach.Add(corners[1]);
    this->Reach.Add(corners[2]);
    this->Reach = this->Reach.Widened(near);
    if (AreaInPlane(Flat(corners[0]), Flat(corners[1]), Flat(corners[2])) < 0)
    {
      std::swap(this->Corners[1], this->Corners[2]);
    }
    for (int axis = 0; axis < 2; ++axis)
    {
      size = std::max({ size, -this->Reach.Low[axis], this->Reach.High[axis] });
    }
    for (int k = 0; k < 3; ++k)
    {
      const Point along = Difference(this->Corners[(k + 1) % 3], this->Corners[k]);
      this->Roundings[k] = Rounding * size * (std::abs(along[0]) + std::abs(along[1]));
    }
  }

  /** Whether any point of the plane may be near it. */
  bool ReachesPlane() const { return this->Reach.Low[2] <= 0 && 0 <= this->Reach.High[2]; }

  /** Whether any point of a polygon in the plane may be near it. */
  bool Reaches(const Polygon& polygon) const
  {
    return polygon.Low[0] <= this->Reach.High[0] && this->Reach.Low[0] <= polygon.High[0] &&
      polygon.Low[1] <= this->Reach.High[1] && this->Reach.Low[1] <= polygon.High[1];
  }

  /**
   * Whether all of a part or a piece of it is covered.
   * @param[out] left in that case the rest: the pieces beyond each edge of the triangle
   */
  bool Covers(const Polygon& part, std::vector<Polygon>& left)
  {
    left.clear();
    if (this->IsNear(part))
    {
      return true;
    }
    if (part.Size + 3 > Polygon::MostCorners || this->IsApartFrom(part))
    {
      return false;
    }
    std::array<Polygon, 4> over;
    std::array<Polygon, 3> beyond;
    over[0] = part;
    for (int k = 0; k < 3; ++k)
    {
      this->Cut(over[k], k, over[k + 1], beyond[k]);
      if (over[k + 1].Size < 3)
      {
        return false;
      }
    }
    if (!this->IsUnderOrOver(over[3]))
    {
      return false;
    }
    for (Polygon& rest : beyond)
    {
      if (rest.Size > 2)
      {
        rest.FindBox();
        if (!this->IsNear(rest))
        {
          left.push_back(rest);
        }
      }
    }
    return true;
  }

private:
  /** Twice the area between an edge and a place, positive within; 0 where it is a rounding error.
   */
  double SideOf(int edge, const PlanarPoint& place) const
  {
    const double area =
      AreaInPlane(Flat(this->Corners[edge]), Flat(this->Corners[(edge + 1) % 3]), place);
    return std::abs(area) <= this->Roundings[edge] ? 0 : area;
  }

  /** Whether an edge of the triangle separates it from a polygon. */
  bool IsApartFrom(const Polygon& polygon) const
  {
    for (int k = 0; k < 3; ++k)
    {
      if (std::none_of(polygon.Corners.begin(), polygon.Corners.begin() + polygon.Size,
            [&](const PlanarPoint& corner) { return this->SideOf(k, corner) > 0; }))
      {
        return true;
      }
    }
    return false;
  }

  /** The parts of a convex polygon within and beyond an edge. The second is empty rather than a
   * sliver of a rounding error, which nothing might cover. */
  void Cut(const Polygon& polygon, int edge, Polygon& within, Polygon& beyond) const
  {
    double sideHere = this->SideOf(edge, polygon.Corners[0]);
    bool isBeyond = false;
    for (int i = 0; i < polygon.Size; ++i)
    {
      const PlanarPoint& here = polygon.Corners[i];
      const PlanarPoint& next = polygon.Corners[i + 1 < polygon.Size ? i + 1 : 0];
      const double sideNext = this->SideOf(edge, next);
      if (sideHere >= 0)
      {
        within.Add(here);
      }
      if (sideHere <= 0)
      {
        beyond.Add(here);
      }
      if ((sideHere > 0 && sideNext < 0) || (sideHere < 0 && sideNext > 0))
      {
        const double t = sideHere / (sideHere - sideNext);
        const PlanarPoint cut = { { here[0] + t * (next[0] - here[0]),
          here[1] + t * (next[1] - here[1]) } };
        within.Add(cut);
        beyond.Add(cut);
      }
      isBeyond = isBeyond || sideHere < 0;
      sideHere = sideNext;
    }
    beyond.Size = isBeyond ? beyond.Size : 0;
  }

  /** Whether all of a convex polygon is near the triangle: distances from a triangle are convex. */
  bool IsNear(const Polygon& polygon)
  {
    // The cheapest tests come first: hardly any polygon passes.
    for (int axis = 0; axis < 2; ++axis)
    {
      if (polygon.Low[axis] < this->Reach.Low[axis] || polygon.High[axis] > this->Reach.High[axis])
      {
        return false;
      }
    }
    if (!this->Distances)
    {
      this->Distances.emplace(this->Corners);
    }
    const double most = this->Near * this->Near;
    return std::all_of(polygon.Corners.begin(), polygon.Corners.begin() + polygon.Size,
      [&](const PlanarPoint& corner) {
        return this->Distances->To({ { corner[0], corner[1], 0 } }, 2 * most) <= most;
      });
  }

  /** Whether the triangle's plane is near a polygon along the normal. */
  bool IsUnderOrOver(const Polygon& polygon) const
  {
    const PlanarPoint a = Flat(this->Corners[0]);
    const PlanarPoint b = Flat(this->Corners[1]);
    const PlanarPoint c = Flat(this->Corners[2]);
    const double area = AreaInPlane(a, b, c);
    return area > 0 &&
      std::all_of(polygon.Corners.begin(), polygon.Corners.begin() + polygon.Size,
        [&](const PlanarPoint& place)
        {
          const double height = (AreaInPlane(place, b, c) * this->Corners[0][2] +
                                  AreaInPlane(a, place, c) * this->Corners[1][2] +
                                  AreaInPlane(a, b, place) * this->Corners[2][2]) /
            area;
          return std::abs(height) <= this->Near;
        });
  }

  std::array<Point, 3> Corners; ///< counter-clockwise in the plane
  double Near;
  Box Reach;
  std::array<double, 3> Roundings; ///< of areas at its edges
  std::optional<SquaredDistances> Distances;
};

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
      this->Parts.back().Add(Flat(this->ToPlane(corner)));
    }
    this->Parts.back().FindBox();
    const Polygon& whole = this->Parts.back();
    this->Size = std::max({ -whole.Low[0], -whole.Low[1], whole.High[0], whole.High[1] });
  }
}

Point UncoveredPart::ToPlane(const Point& place) const
{
  const Point from = Difference(place, this->Origin);
  return { { Dot(from, this->Axes[0]), Dot(from, this->Axes[1]), Dot(from, this->Axes[2]) } };
}

void UncoveredPart::Cover(const std::array<Point, 3>& near)
{
  NearTriangle triangle(
    { { this->ToPlane(near[0]), this->ToPlane(near[1]), this->ToPlane(near[2]) } }, this->Near,
    this->Size);
  if (!triangle.ReachesPlane())
  {
    return;
  }
  // Most triangles reach few parts: the others stay where they are.
  for (std::size_t i = this->Parts.size(); i-- > 0;)
  {
    if (triangle.Reaches(this->Parts[i]) && triangle.Covers(this->Parts[i], this->Left))
    {
      this->Parts[i] = this->Parts.back();
      this->Parts.pop_back();
      this->Parts.insert(this->Parts.end(), this->Left.begin(), this->Left.end());
    }
  }
}
} // namespace insideout
