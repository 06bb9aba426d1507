// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

namespace insideout
{
/** A point in a plane, by two coordinates. */
using PlanarPoint = std::array<double, 2>;

/**
 * Lengths and angles for coordinates along oblique axes: the map of coordinates (x, y) to
 * orthonormal ones, (XX x + XY y, YY y), with XX and YY above 0. It keeps lines of equal y, and
 * their direction.
 */
struct PlanarMetric
{
  double XX = 1;
  double XY = 0;
  double YY = 1;

  PlanarPoint Map(const PlanarPoint& p) const
  {
    return { this->XX * p[0] + this->XY * p[1], this->YY * p[1] };
  }
  double Distance(const PlanarPoint& a, const PlanarPoint& b) const
  {
    const PlanarPoint difference = this->Map({ b[0] - a[0], b[1] - a[1] });
    return std::hypot(difference[0], difference[1]);
  }
  bool IsPerpendicular() const { return this->XX == 1 && this->XY == 0 && this->YY == 1; }
};

/** The signed area of a triangle, positive if a, b, c run counter-clockwise. */
inline double AreaOf(
  const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c, const PlanarMetric& metric)
{
  return 0.5 * metric.XX * metric.YY *
    ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
}

/** The angle at the first of three corners, in degrees. */
inline double AngleAt(
  const PlanarPoint& p, const PlanarPoint& q, const PlanarPoint& r, const PlanarMetric& metric)
{
  constexpr double degrees = 180 / 3.14159265358979323846;
  const PlanarPoint u = metric.Map({ q[0] - p[0], q[1] - p[1] });
  const PlanarPoint v = metric.Map({ r[0] - p[0], r[1] - p[1] });
  return std::atan2(std::abs(u[0] * v[1] - u[1] * v[0]), u[0] * v[0] + u[1] * v[1]) * degrees;
}
} // namespace insideout
