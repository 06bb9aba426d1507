// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/FindPlane.h"

#include "Common/Error.h"
#include "Common/PointPredicates.h"
#include "Common/ScaledPoints.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
namespace
{
/** Components of a normal from this share of the largest on count as equal: rounded points of a
 * plane at 45 degrees lead to the same axes, by which thin triangles remain positive. */
constexpr double AlmostSteepest = 1 - 16 * RoundingOfSingles;

/** The first point with the largest `size`. */
template <typename Size>
const Point& Farthest(const std::vector<Point>& points, const Size& size)
{
  return *std::max_element(points.begin(), points.end(),
    [&](const Point& a, const Point& b) { return size(a) < size(b); });
}

/** The metric of coordinates along two axes, in a plane with slopes a and b along them. */
PlanarMetric MetricOf(double a, double b)
{
  PlanarMetric metric;
  metric.XX = std::sqrt(1 + a * a);
  metric.XY = a * b / metric.XX;
  metric.YY = std::sqrt((1 + a * a + b * b) / (1 + a * a));
  return metric;
}

double RiseAlong(const Plane& plane, int k)
{
  return -plane.Normal[plane.Axes[k]] / plane.Normal[plane.Dropped] + 0.0; // no -0
}

/** The distance of the scaled points from the plane through three of them. */
double LargestDistance(
  const std::vector<Point>& points, const std::array<Point, 3>& corners, const Point& normal)
{
  double distance = 0;
  for (const Point& p : points)
  {
    if (Orient3D(corners[0], corners[1], corners[2], p) != 0)
    {
      const double rounded = std::abs(Dot(normal, Difference(p, corners[0])));
      distance = std::max({ distance, rounded, 0x1p-60 }); // not exactly in the plane
    }
  }
  return distance;
}
} // namespace

Plane FindPlane(const std::vector<Point>& points)
{
  if (points.empty())
  {
    throw Error(ErrorCode::EmptySurface, "the curve has no points");
  }
  Plane plane;
  plane.Exponent = LargestExponent(points);
  const std::vector<Point> scaled = ScaledPoints(points, -plane.Exponent);
  const Point& a = scaled.front();
  const Point& b = Farthest(scaled, [&](const Point& p) { return Distance(a, p); });
  const Point& c = Farthest(scaled, [&](const Point& p) { return Length(NormalOf(a, b, p)); });
  const Point normal = NormalOf(a, b, c);
  const double length = Length(normal);
  if (IsDegenerate(a, b, c) || !(length > 0))
  {
    throw Error(
      ErrorCode::AllDegenerate, "all points lie on one line: there is no area to enclose");
  }
  const double most = std::max({ std::abs(normal[0]), std::abs(normal[1]), std::abs(normal[2]) });
  const auto steepest = std::find_if(normal.begin(), normal.end(),
    [&](double component) { return std::abs(component) >= AlmostSteepest * most; });
  plane.Dropped = static_cast<int>(steepest - normal.begin());
  plane.Axes = { { (plane.Dropped + 1) % 3, (plane.Dropped + 2) % 3 } };
  for (int k = 0; k < 3; ++k)
  {
    plane.Normal[k] = (*steepest > 0 ? normal[k] : -normal[k]) / length + 0.0;
  }
  plane.Origin = a;
  plane.Metric = MetricOf(RiseAlong(plane, 0), RiseAlong(plane, 1));
  plane.Distance = LargestDistance(scaled, { { a, b, c } }, plane.Normal);
  return plane;
}

PlanarPoint Plane::Project(const Point& p) const
{
  const PowerOfTwo power(-this->Exponent);
  return { power.Times(p[this->Axes[0]]), power.Times(p[this->Axes[1]]) };
}

Point Plane::Lift(const PlanarPoint& p) const
{
  Point lifted;
  lifted[this->Dropped] = this->Origin[this->Dropped];
  for (int k = 0; k < 2; ++k)
  {
    lifted[this->Axes[k]] = p[k];
    lifted[this->Dropped] += RiseAlong(*this, k) * (p[k] - this->Origin[this->Axes[k]]);
  }
  const PowerOfTwo power(this->Exponent);
  return { power.Times(lifted[0]), power.Times(lifted[1]), power.Times(lifted[2]) };
}

Point Plane::Foot(const Point& p) const
{
  const PowerOfTwo power(-this->Exponent);
  const PowerOfTwo back(this->Exponent);
  Point foot = { { power.Times(p[0]), power.Times(p[1]), power.Times(p[2]) } };
  const double height = Dot(this->Normal, Difference(foot, this->Origin));
  for (int k = 0; k < 3; ++k)
  {
    foot[k] = back.Times(foot[k] - height * this->Normal[k]);
  }
  return foot;
}

Plane Plane::Turned() const
{
  Plane turned = *this;
  std::swap(turned.Axes[0], turned.Axes[1]);
  for (double& component : turned.Normal)
  {
    component = -component + 0.0;
  }
  turned.Metric = MetricOf(RiseAlong(turned, 0), RiseAlong(turned, 1));
  return turned;
}
} // namespace insideout
