// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/CurveWindingNumber.h"

#include "Common/ChunkedLoop.h"
#include "Common/Vectors.h"
#include "WindingNumber/Pi.h"

#include <cmath>
#include <limits>

namespace insideout
{
namespace
{
std::vector<CountedSegment> CountedSegments(const SegmentComplex& curve)
{
  std::vector<CountedSegment> segments;
  segments.reserve(curve.Segments.size());
  for (Id s = 0; s < curve.NumberOfSegments(); ++s)
  {
    segments.push_back({ curve.Segments[s][0], curve.Segments[s][1], curve.Multiplicity[s] });
  }
  return segments;
}
} // namespace

CurveWindingNumber::CurveWindingNumber(const PlanarHull& hull)
  : Plane(hull.Plane)
  , Number(hull.Curve.Points, CountedSegments(hull.Curve), hull.Plane.Metric)
{
  std::vector<double> ends(hull.Curve.Points.size(), 0);
  for (Id s = 0; s < hull.Curve.NumberOfSegments(); ++s)
  {
    ends[hull.Curve.Segments[s][0]] -= hull.Curve.Multiplicity[s];
    ends[hull.Curve.Segments[s][1]] += hull.Curve.Multiplicity[s];
  }
  for (std::size_t p = 0; p < ends.size(); ++p)
  {
    if (ends[p] != 0)
    {
      this->OpenEnds.push_back({ hull.Curve.Points[p], ends[p] });
    }
  }
}

double CurveWindingNumber::At(const Point& p) const
{
  return IsFinite(p) ? this->Number.At(this->Plane.Project(this->Plane.Foot(p)))
                     : std::numeric_limits<double>::quiet_NaN();
}

std::vector<double> CurveWindingNumber::At(
  const std::vector<Point>& points, Monitor& monitor, const ProgressRange& progress) const
{
  std::vector<double> w(points.size());
  const double nanosecondsPerPoint = 1000;
  ChunkedLoop(static_cast<Id>(points.size()), nanosecondsPerPoint, monitor, progress,
    [&](Id i) { w[i] = this->At(points[i]); });
  monitor.Check(progress, 1);
  return w;
}

/**
 * The derivative of each end's argument: perpendicular to its direction, with the inverse of its
 * distance.
 */
Point CurveWindingNumber::Gradient(const Point& p) const
{
  const PlanarMetric& metric = this->Plane.Metric;
  const PlanarPoint foot = this->Plane.Project(this->Plane.Foot(p));
  PlanarPoint along = { 0, 0 }; // in orthonormal coordinates
  for (const CountedPlace& end : this->OpenEnds)
  {
    const PlanarPoint u = metric.Map({ end.Place[0] - foot[0], end.Place[1] - foot[1] });
    const double square = u[0] * u[0] + u[1] * u[1];
    if (square > 0)
    {
      along[0] += end.Count * u[1] / square;
      along[1] -= end.Count * u[0] / square;
    }
  }
  const double y = along[1] / metric.YY;
  const PlanarPoint step = { (along[0] - metric.XY * y) / metric.XX, y };
  Point gradient = Difference(this->Plane.Lift(step), this->Plane.Lift({ 0, 0 }));
  for (double& component : gradient)
  {
    // Coordinates in the plane are scaled by a power of two, and so is the lifted gradient.
    component = std::ldexp(component, -2 * this->Plane.Exponent) / (2 * Pi);
  }
  return gradient;
}
} // namespace insideout
