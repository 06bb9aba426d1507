// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/CurveDefects.h"

#include "Common/DisjointSets.h"
#include "Common/SortUniquely.h"
#include "Common/Stages.h"
#include "Planar/SegmentMeetings.h"

#include <map>

namespace insideout
{
namespace
{
/** Components numbered by their first segments. */
std::vector<Id> ComponentsOf(const SegmentComplex& curve)
{
  DisjointSets sets(curve.Points.size());
  for (const Segment& segment : curve.Segments)
  {
    sets.Join(segment[0], segment[1]);
  }
  std::map<Id, Id> numbers;
  std::vector<Id> components;
  for (const Segment& segment : curve.Segments)
  {
    const auto [found, isNew] =
      numbers.emplace(sets.Find(segment[0]), static_cast<Id>(numbers.size()));
    components.push_back(found->second);
  }
  return components;
}

/** The number of other segments that each segment meets. */
std::vector<Id> CountMeetings(const SegmentComplex& curve, const SegmentMeetings& meetings)
{
  std::vector<Id> count(curve.Segments.size(), 0);
  for (const Segment& pair : meetings.Crossings)
  {
    ++count[pair[0]];
    ++count[pair[1]];
  }
  for (const SegmentTouch& touch : meetings.Touches)
  {
    ++count[touch.Segment];
  }
  return count;
}

void AddPoints(const SegmentComplex& curve, const std::vector<Id>& points, CurveDefect type,
  CurveDefects& defects)
{
  for (const Id p : points)
  {
    const PointOrigin& origin = curve.Origins[p];
    defects.Points.push_back({ curve.Points[p], origin.IsInput() ? origin.Points[0] : None, type });
  }
}

std::vector<Id> OpenEnds(const SegmentComplex& curve)
{
  std::vector<long> sums(curve.Points.size(), 0);
  for (Id s = 0; s < curve.NumberOfSegments(); ++s)
  {
    sums[curve.Segments[s][0]] -= curve.Multiplicity[s];
    sums[curve.Segments[s][1]] += curve.Multiplicity[s];
  }
  std::vector<Id> ends;
  for (std::size_t p = 0; p < sums.size(); ++p)
  {
    if (sums[p] != 0)
    {
      ends.push_back(static_cast<Id>(p));
    }
  }
  return ends;
}
} // namespace

CurveDefects FindCurveDefects(const SegmentSoup& soup, const Plane& plane,
  const PlanarHullParameters& parameters, Monitor& monitor)
{
  const CountedCurve counted = CountSegments(soup, plane, parameters.Chain, monitor);
  const SegmentComplex& curve = counted.Curve;
  const SegmentMeetings meetings = FindSegmentMeetings(
    curve.Points, curve.Segments, {}, monitor, { Stages::FindingIntersections, 0, 1 });
  const PlanarHull hull = MeshPlanarHull(soup, plane, parameters, monitor);
  const SegmentComplex& resolved = hull.Curve;

  CurveDefects defects;
  defects.TurnedSegments = hull.TurnedSegments;
  defects.Areas = hull.Areas;
  defects.Warnings = hull.Warnings;
  defects.Counts = counted.Counts;
  defects.IntersectingPairs = meetings.Pairs;
  defects.Segments.resize(soup.Segments.size());
  for (const Id s : counted.DegenerateSegments)
  {
    defects.Segments[s].Degenerate = true;
  }
  const std::vector<Id> components = ComponentsOf(curve);
  const std::vector<Id> met = CountMeetings(curve, meetings);
  for (Id s = 0; s < curve.NumberOfSegments(); ++s)
  {
    for (Id i = curve.SourceOffsets[s]; i < curve.SourceOffsets[s + 1]; ++i)
    {
      defects.Segments[curve.Sources[i].Segment] = { components[s], met[s], false,
        i > curve.SourceOffsets[s] };
    }
  }

  AddPoints(curve, OpenEnds(curve), CurveDefect::OpenEnd, defects);
  std::vector<Id> crossings;
  for (std::size_t p = curve.Points.size(); p < resolved.Points.size(); ++p)
  {
    crossings.push_back(static_cast<Id>(p)); // new points come behind the others
  }
  AddPoints(resolved, crossings, CurveDefect::Crossing, defects);
  std::vector<Id> junctions;
  for (const SegmentTouch& touch : meetings.Touches)
  {
    junctions.push_back(touch.Point);
  }
  SortUniquely(junctions);
  AddPoints(curve, junctions, CurveDefect::TJunction, defects);
  return defects;
}
} // namespace insideout
