// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/SurfaceWindingNumber.h"

#include "Common/ChunkedLoop.h"
#include "Common/ScaledPoints.h"
#include "Common/Stages.h"
#include "Common/Vectors.h"
#include "WindingNumber/ApproximateWindingNumber.h"
#include "WindingNumber/ExactWindingNumber.h"
#include "WindingNumber/HierarchicalWindingNumber.h"
#include "WindingNumber/Pi.h"
#include "WindingNumber/SpatialOrder.h"
#include "WindingNumber/WindingNumberSum.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace insideout
{
namespace
{
FacetComplex ComplexOf(
  const std::vector<Point>& points, const std::vector<CountedTriangle>& triangles)
{
  FacetComplex surface;
  surface.Points = points;
  for (const CountedTriangle& triangle : triangles)
  {
    surface.Facets.push_back(triangle.Corners);
    surface.Multiplicity.push_back(static_cast<std::int16_t>(triangle.Count));
  }
  return surface;
}

/** The field at p of a line current along the edge from a to b, without its constant. */
void AddBiotSavart(const Point& a, const Point& b, const Point& p, double count, Point& sum)
{
  const Point u = Difference(a, p);
  const Point v = Difference(b, p);
  const double uv = Dot(u, v);
  const double lengthU = std::sqrt(Dot(u, u));
  const double lengthV = std::sqrt(Dot(v, v));
  const double lengths = lengthU * lengthV;
  const double denominator = lengths * (lengths + uv);
  const Point cross = Cross(u, v);
  const double squaredCross = Dot(cross, cross);
  if (squaredCross == 0)
  {
    return; // in line with the edge
  }
  // Where the edge is seen under nearly 180 degrees the denominator's sum cancels.
  const double sumOfLengths = lengthU + lengthV;
  const double factor =
    uv > 0 ? sumOfLengths / denominator : sumOfLengths * (lengths - uv) / (lengths * squaredCross);
  for (int axis = 0; axis < 3; ++axis)
  {
    sum[axis] += count * factor * cross[axis];
  }
}
} // namespace

class SurfaceWindingNumber::Implementation
{
public:
  Implementation(const FacetComplex& surface, std::vector<CountedTriangle> triangles,
    std::vector<CountedEdge> boundary, const WindingNumberParameters& parameters, Monitor& monitor)
    : Exponent(LargestExponent(surface.Points))
    , Points(ScaledPoints(surface.Points, -this->Exponent))
    , Method(parameters.Method)
    , OpenEdges(std::move(boundary))
  {
    switch (this->Method)
    {
      case WindingNumberMethod::Exact:
        this->Exact.emplace(this->Points, std::move(triangles), this->OpenEdges, monitor,
          ProgressRange{ Stages::WindingNumbers, 0, 0 });
        break;
      case WindingNumberMethod::Naive:
        this->Surface = ComplexOf(this->Points, triangles);
        break;
      case WindingNumberMethod::Hierarchical:
        this->Hierarchical.emplace(this->Points, std::move(triangles));
        break;
      case WindingNumberMethod::Approximate:
        this->Approximate.emplace(
          this->Points, std::move(triangles), parameters.ApproximationOrder, parameters.Accuracy);
        break;
    }
  }

  Point Scale(const Point& point) const { return ScaledPoints({ point }, -this->Exponent).front(); }

  /** At points that are finite and not far away, `scaled`. */
  std::vector<double> At(
    const std::vector<Point>& scaled, Monitor& monitor, const ProgressRange& progress) const
  {
    if (this->Method == WindingNumberMethod::Exact)
    {
      return this->Exact->Evaluate(scaled, monitor, progress);
    }
    if (this->Method == WindingNumberMethod::Naive)
    {
      const std::vector<Tetrahedron> cells = CellsOfPoints(scaled.size());
      return WindingNumberSum(this->Surface, { scaled, cells }, monitor, progress);
    }
    const std::vector<Id> order = SpatialOrder(scaled);
    std::vector<double> w(scaled.size());
    const Id pointsPerCall = 64;
    const Id points = static_cast<Id>(scaled.size());
    ChunkedLoop((points + pointsPerCall - 1) / pointsPerCall, 1e6, monitor, progress,
      [&](Id call)
      {
        for (Id i = call * pointsPerCall; i < std::min(points, (call + 1) * pointsPerCall); ++i)
        {
          w[order[i]] = this->Method == WindingNumberMethod::Hierarchical
            ? this->Hierarchical->At(scaled[order[i]])
            : this->Approximate->At(scaled[order[i]]);
        }
      });
    return w;
  }

  const int Exponent;
  const std::vector<Point> Points; // scaled
  const WindingNumberMethod Method;
  const std::vector<CountedEdge> OpenEdges;
  std::optional<ExactWindingNumber> Exact;
  FacetComplex Surface; // scaled
  std::optional<HierarchicalWindingNumber> Hierarchical;
  std::optional<ApproximateWindingNumber> Approximate;
};

SurfaceWindingNumber::SurfaceWindingNumber(
  const FacetComplex& surface, const WindingNumberParameters& parameters, Monitor& monitor)
{
  std::vector<CountedTriangle> triangles = CountedFacets(surface);
  std::vector<CountedEdge> boundary =
    CountedBoundary(triangles, static_cast<Id>(surface.Points.size()));
  this->Internals = std::make_unique<const Implementation>(
    surface, std::move(triangles), std::move(boundary), parameters, monitor);
}

SurfaceWindingNumber::SurfaceWindingNumber(const FacetComplex& surface,
  std::vector<CountedEdge> boundary, const WindingNumberParameters& parameters, Monitor& monitor)
  : Internals(std::make_unique<const Implementation>(
      surface, CountedFacets(surface), std::move(boundary), parameters, monitor))
{
}

SurfaceWindingNumber::~SurfaceWindingNumber() = default;

std::vector<double> SurfaceWindingNumber::At(
  const std::vector<Point>& points, Monitor& monitor, const ProgressRange& progress) const
{
  monitor.Check(progress.Stage, progress.Begin);
  const std::vector<Point> scaled = ScaledPoints(points, -this->Internals->Exponent);
  if (std::all_of(scaled.begin(), scaled.end(), IsNear))
  {
    std::vector<double> w = this->Internals->At(scaled, monitor, progress);
    monitor.Check(progress.Stage, progress.End);
    return w;
  }
  std::vector<double> w(points.size(), std::numeric_limits<double>::quiet_NaN());
  std::vector<Point> near;
  std::vector<std::size_t> which;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (IsNear(scaled[i]))
    {
      near.push_back(scaled[i]);
      which.push_back(i);
    }
    else if (IsFinite(points[i]))
    {
      w[i] = 0;
    }
  }
  const std::vector<double> values = this->Internals->At(near, monitor, progress);
  for (std::size_t i = 0; i < which.size(); ++i)
  {
    w[which[i]] = values[i];
  }
  monitor.Check(progress.Stage, progress.End);
  return w;
}

void SurfaceWindingNumber::InGrid(const GridPlaces& grid, std::optional<double> sideOf,
  const SliceVisitor& visit, Monitor& monitor, const ProgressRange& progress) const
{
  monitor.Check(progress.Stage, progress.Begin);
  const Implementation& internals = *this->Internals;
  GridPlaces scaled = grid;
  const PowerOfTwo power(-internals.Exponent);
  bool isNear = true;
  for (std::vector<double>& axis : scaled.Axes)
  {
    for (double& x : axis)
    {
      x = power.Times(x);
    }
    const auto doNotAscend = [](double a, double b) { return !(a < b); };
    isNear = isNear && IsNear({ axis.front(), axis.back(), 0 }) &&
      std::adjacent_find(axis.begin(), axis.end(), doNotAscend) == axis.end();
  }
  if (internals.Method == WindingNumberMethod::Exact && isNear)
  {
    internals.Exact->EvaluateInGrid(scaled, sideOf, visit, monitor, progress);
  }
  else
  {
    this->SliceBySlice(grid, visit, monitor, progress);
  }
  monitor.Check(progress.Stage, progress.End);
}

/** Evaluate as at any points: for far or unordered places, and for the other methods. */
void SurfaceWindingNumber::SliceBySlice(const GridPlaces& grid, const SliceVisitor& visit,
  Monitor& monitor, const ProgressRange& progress) const
{
  std::vector<Point> places(grid.SizeOfSlice());
  const double slices = grid.Size(2);
  for (Id slice = 0; slice < grid.Size(2); ++slice)
  {
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      places[i] = grid.InSlice(slice, i);
    }
    visit(slice,
      this->At(places, monitor,
        { progress.Stage, progress.At(slice / slices), progress.At((slice + 1) / slices) }));
  }
}

double SurfaceWindingNumber::At(const Point& point) const
{
  if (!IsFinite(point))
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const Point scaled = this->Internals->Scale(point);
  if (!IsNear(scaled))
  {
    return 0;
  }
  switch (this->Internals->Method)
  {
    case WindingNumberMethod::Hierarchical:
      return this->Internals->Hierarchical->At(scaled);
    case WindingNumberMethod::Approximate:
      return this->Internals->Approximate->At(scaled);
    case WindingNumberMethod::Exact:
      return this->Internals->Exact->At(scaled);
    case WindingNumberMethod::Naive:
      break;
  }
  Monitor silent;
  return this->Internals->At({ scaled }, silent, { Stages::WindingNumbers, 0, 1 }).front();
}

Point SurfaceWindingNumber::Gradient(const Point& point) const
{
  const Point scaled = this->Internals->Scale(point);
  Point gradient = { 0, 0, 0 };
  if (!IsNear(scaled))
  {
    return gradient;
  }
  for (const CountedEdge& edge : this->Internals->OpenEdges)
  {
    AddBiotSavart(this->Internals->Points[edge.From], this->Internals->Points[edge.To], scaled,
      static_cast<double>(edge.Count), gradient);
  }
  for (double& x : gradient)
  {
    x = std::ldexp(x / (4 * Pi), -this->Internals->Exponent);
  }
  return gradient;
}

bool SurfaceWindingNumber::IsClosed() const
{
  return this->Internals->OpenEdges.empty();
}
} // namespace insideout
