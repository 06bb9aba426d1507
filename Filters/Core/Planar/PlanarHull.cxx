// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/PlanarHull.h"

#include "Planar/OrientCurves.h"
#include "Planar/ResolveSegments.h"
#include "Planar/TriangulateHull.h"
#include "Planar/WindingNumberOfTriangles.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
namespace
{
void AddWarnings(PlanarHull& hull, Id leftOut)
{
  if (hull.Counts.DegenerateSegments > 0)
  {
    hull.Warnings.push_back(std::to_string(hull.Counts.DegenerateSegments) +
      " degenerate segments (without length) are left out");
  }
  if (leftOut > 0)
  {
    hull.Warnings.push_back(std::to_string(leftOut) +
      " segments still cross others after rounding: they count, but do not shape the mesh");
  }
}
} // namespace

PlanarHull MeshPlanarHull(const SegmentSoup& soup, const Plane& plane,
  const PlanarHullParameters& parameters, Monitor& monitor)
{
  PlanarHull hull;
  hull.Plane = plane;
  Statistics& statistics = hull.Statistics;
  Stopwatch stopwatch;
  CountedCurve counted = CountSegments(soup, plane, parameters.Chain, monitor);
  hull.Counts = counted.Counts;
  hull.MergedInto = std::move(counted.MergedInto);
  hull.DegenerateSegments = std::move(counted.DegenerateSegments);
  AddCounts(hull.Counts, statistics);
  const double validateSeconds = stopwatch.Lap();

  ResolvedCurve resolved = ResolveSegments(counted.Curve, monitor);
  hull.Curve = std::move(resolved.Curve);
  const Id leftOut = hull.Curve.NumberOfSegments() - hull.Curve.NumberOfConstraints;
  statistics.emplace_back("IntersectingPairs", resolved.IntersectingPairs);
  statistics.emplace_back("ResolvedPoints", hull.Curve.Points.size());
  statistics.emplace_back("ResolvedSegments", hull.Curve.NumberOfSegments());
  statistics.emplace_back("LeftOutSegments", leftOut);
  AddWarnings(hull, leftOut);
  const double resolveSeconds = stopwatch.Lap();

  hull.Mesh = TriangulateHull(hull.Curve, plane.Metric, monitor);
  statistics.emplace_back("HullCells", hull.Mesh.NumberOfCells());
  const double meshSeconds = stopwatch.Lap();

  const CurveTurns turns =
    OrientCurves(counted.Curve, parameters.Orientation, plane, hull.Mesh, hull.Curve, monitor);
  hull.TurnedSegments = turns.Segments;
  hull.Warnings.insert(hull.Warnings.end(), turns.Warnings.begin(), turns.Warnings.end());
  statistics.emplace_back("TurnedSegments", hull.TurnedSegments.size());
  const double orientSeconds = stopwatch.Lap();

  hull.W = WindingNumberOfTriangles(hull.Curve, hull.Mesh, plane.Metric, monitor);
  const auto [least, most] = std::minmax_element(hull.W.begin(), hull.W.end());
  statistics.emplace_back("Closed", NumberOfOpenEnds(hull.Curve) == 0);
  statistics.emplace_back("MinimumW", *least);
  statistics.emplace_back("MaximumW", *most);
  statistics.emplace_back("SecondsValidate", validateSeconds + orientSeconds);
  statistics.emplace_back("SecondsPre", resolveSeconds);
  statistics.emplace_back("SecondsCDT", meshSeconds);
  statistics.emplace_back("SecondsW", stopwatch.Lap());
  return hull;
}

double EnclosedArea(const PlanarHull& hull)
{
  double area = 0;
  for (std::size_t c = 0; c < hull.W.size(); ++c)
  {
    const auto& [p, q, r] = hull.Mesh.Cells[c];
    area += hull.W[c] > 0.5
      ? AreaOf(hull.Curve.Points[p], hull.Curve.Points[q], hull.Curve.Points[r], hull.Plane.Metric)
      : 0;
  }
  return std::ldexp(area, 2 * hull.Plane.Exponent);
}
} // namespace insideout
