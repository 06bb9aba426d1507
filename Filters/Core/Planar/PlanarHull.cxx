// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/PlanarHull.h"

#include "Common/DisjointSets.h"
#include "Planar/OrientCurves.h"
#include "Planar/ResolveSegments.h"
#include "Planar/TriangulateHull.h"
#include "Planar/WindingNumberOfTriangles.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

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
  if (hull.Counts.TwoSidedCurves > 0)
  {
    hull.Warnings.push_back(std::to_string(hull.Counts.TwoSidedCurves) +
      " closed curves that are given both ways are kept once, turned counter-clockwise");
  }
  if (leftOut > 0)
  {
    hull.Warnings.push_back(std::to_string(leftOut) +
      " segments still cross others after rounding: they count, but do not shape the mesh");
  }
}

bool IsInside(double w)
{
  return w > 0.5;
}

bool IsOdd(double w)
{
  return std::lround(w) % 2 != 0;
}

bool IsTwice(double w)
{
  return w > 1.5;
}

/** Whether a contour lies in another one that runs the same way: where w is 2 and no vertex nearby
 * is one of the outside's. Areas where contours overlap reach the outside where these cross. */
bool HasContourWithin(const PlanarHull& hull)
{
  DisjointSets areas(hull.Curve.Points.size());
  std::vector<bool> isOutside(hull.Curve.Points.size(), false);
  for (std::size_t c = 0; c < hull.W.size(); ++c)
  {
    const auto& [p, q, r] = hull.Mesh.Cells[c];
    if (IsTwice(hull.W[c]))
    {
      areas.Join(p, q);
      areas.Join(p, r);
    }
    else if (!IsInside(hull.W[c]))
    {
      isOutside[p] = isOutside[q] = isOutside[r] = true;
    }
  }
  for (std::size_t p = 0; p < isOutside.size(); ++p)
  {
    if (isOutside[p])
    {
      isOutside[areas.Find(static_cast<Id>(p))] = true;
    }
  }
  for (std::size_t c = 0; c < hull.W.size(); ++c)
  {
    if (IsTwice(hull.W[c]) && !isOutside[areas.Find(hull.Mesh.Cells[c][0])])
    {
      return true;
    }
  }
  return false;
}

/** @param[in] given winding numbers before segments were turned over
 * @param[in] crosses whether segments meet beyond their ends */
AreaReadings ReadAreas(const PlanarHull& hull, const std::vector<double>& given, bool crosses)
{
  AreaReadings areas;
  bool differ = false;
  for (std::size_t c = 0; c < hull.W.size(); ++c)
  {
    const auto& [p, q, r] = hull.Mesh.Cells[c];
    const double area =
      AreaOf(hull.Curve.Points[p], hull.Curve.Points[q], hull.Curve.Points[r], hull.Plane.Metric);
    areas.EvenOdd += IsOdd(hull.W[c]) ? area : 0;
    areas.Winding += IsInside(hull.W[c]) ? area : 0;
    areas.AsGiven += IsInside(given[c]) ? area : 0;
    differ = differ || IsOdd(hull.W[c]) != IsInside(hull.W[c]) ||
      IsInside(hull.W[c]) != IsInside(given[c]);
  }
  const auto [least, most] = std::minmax_element(given.begin(), given.end());
  areas.Across = differ && crosses && *least < -0.5 && IsInside(*most);
  areas.Within = differ &&
    (crosses ? HasContourWithin(hull) : std::any_of(hull.W.begin(), hull.W.end(), IsTwice));
  for (double* area : { &areas.EvenOdd, &areas.Winding, &areas.AsGiven })
  {
    *area = std::ldexp(*area, 2 * hull.Plane.Exponent);
  }
  return areas;
}

std::string WarningAbout(const AreaReadings& areas)
{
  char text[200];
  std::snprintf(text, sizeof(text),
    "the contours enclose an area of %.6g by the winding number, %.6g by even-odd and %.6g as "
    "given: ",
    areas.Winding, areas.EvenOdd, areas.AsGiven);
  return text +
    std::string(areas.Across ? "Orientation chooses"
                             : "a contour within another is a hole only if it runs the other way");
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

  const std::vector<std::int16_t> given = hull.Curve.Multiplicity;
  const CurveTurns turns =
    OrientCurves(counted.Curve, parameters.Orientation, plane, hull.Mesh, hull.Curve, monitor);
  hull.TurnedSegments = turns.Segments;
  hull.Warnings.insert(hull.Warnings.end(), turns.Warnings.begin(), turns.Warnings.end());
  statistics.emplace_back("TurnedSegments", hull.TurnedSegments.size());
  const double orientSeconds = stopwatch.Lap();

  hull.W = WindingNumberOfTriangles(hull.Curve, hull.Mesh, plane.Metric, monitor);
  const bool crosses = resolved.IntersectingPairs > 0;
  if (turns.Segments.empty() || !crosses)
  {
    hull.Areas = ReadAreas(hull, hull.W, crosses);
  }
  else
  {
    SegmentComplex asGiven = hull.Curve;
    asGiven.Multiplicity = given;
    hull.Areas =
      ReadAreas(hull, WindingNumberOfTriangles(asGiven, hull.Mesh, plane.Metric, monitor), crosses);
  }
  if (hull.Areas.Differ())
  {
    hull.Warnings.push_back(WarningAbout(hull.Areas));
  }
  AddAreas(hull.Areas, statistics);
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

void AddAreas(const AreaReadings& areas, Statistics& statistics)
{
  if (areas.Differ())
  {
    statistics.emplace_back("AreaByEvenOdd", areas.EvenOdd);
    statistics.emplace_back("AreaByWindingNumber", areas.Winding);
    statistics.emplace_back("AreaAsGiven", areas.AsGiven);
  }
}
} // namespace insideout
