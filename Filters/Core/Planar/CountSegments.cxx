// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/CountSegments.h"

#include "Common/DisjointSets.h"
#include "Common/Edge.h"
#include "Common/Error.h"
#include "Common/Stages.h"
#include "Common/Vectors.h"
#include "Planar/TwoSidedCurves.h"
#include "Validate/MergePoints.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <tuple>

namespace insideout
{
namespace
{
/** Merge points that coincide in space or, up to rounding, in the plane. */
std::vector<Id> MergeInPlane(const std::vector<Point>& points, const Plane& plane, double tolerance)
{
  std::vector<Id> merged = MergePoints(points, tolerance);
  std::vector<Point> flat;
  flat.reserve(points.size());
  for (const Id p : merged)
  {
    const PlanarPoint place = plane.Project(points[p]);
    flat.push_back({ { place[0], place[1], 0 } });
  }
  return MergePoints(flat, 0);
}

/** A segment of the soup, by its merged ends. */
struct GivenSegment
{
  Edge Ends; ///< the lower first
  Id Index;
  bool IsTurned; ///< whether it runs to the lower one
};

/** The signed count of a group of segments along the direction of the first. */
long CountGroup(const SegmentSoup& soup, const std::vector<GivenSegment>& segments,
  std::size_t first, std::size_t last, bool countDuplicates)
{
  std::array<long, 2> count{ { 0, 0 } }; // numbers along and against
  for (std::size_t i = first; i < last; ++i)
  {
    const Id s = segments[i].Index;
    if (soup.NonParticipating.empty() || soup.NonParticipating[s] == 0)
    {
      count[segments[i].IsTurned != segments[first].IsTurned] +=
        soup.Multiplicity.empty() ? 1 : soup.Multiplicity[s];
    }
  }
  const bool oncePerDirection = soup.Multiplicity.empty() && !countDuplicates;
  const long multiplicity =
    oncePerDirection ? (count[0] > 0) - (count[1] > 0) : count[0] - count[1];
  if (std::abs(multiplicity) > std::numeric_limits<std::int16_t>::max())
  {
    throw Error(ErrorCode::TooLarge,
      "segment " + std::to_string(segments[first].Index) + " is given " +
        std::to_string(last - first) + " times, more than can be counted");
  }
  return multiplicity;
}

/** Merge segments with the same ends, in the order of the first ones. */
void CollectSegments(const SegmentSoup& soup, bool countDuplicates, CountedCurve& counted)
{
  std::vector<GivenSegment> segments;
  segments.reserve(soup.Segments.size());
  for (Id s = 0; s < static_cast<Id>(soup.Segments.size()); ++s)
  {
    const Id from = counted.MergedInto[soup.Segments[s][0]];
    const Id to = counted.MergedInto[soup.Segments[s][1]];
    if (from == to)
    {
      counted.DegenerateSegments.push_back(s);
    }
    else
    {
      segments.push_back({ EdgeBetween(from, to), s, to < from });
    }
  }
  counted.Counts.DegenerateSegments = static_cast<Id>(counted.DegenerateSegments.size());
  std::sort(segments.begin(), segments.end(),
    [](const GivenSegment& a, const GivenSegment& b)
    { return std::tie(a.Ends, a.Index) < std::tie(b.Ends, b.Index); });
  std::vector<std::array<std::size_t, 2>> groups;
  for (std::size_t first = 0, last = 0; first < segments.size(); first = last)
  {
    while (last < segments.size() && segments[last].Ends == segments[first].Ends)
    {
      ++last;
    }
    groups.push_back({ { first, last } });
  }
  std::sort(groups.begin(), groups.end(),
    [&](const auto& a, const auto& b) { return segments[a[0]].Index < segments[b[0]].Index; });

  SegmentComplex& curve = counted.Curve;
  for (const auto& [first, last] : groups)
  {
    const GivenSegment& leader = segments[first];
    curve.Segments.push_back(leader.IsTurned ? Segment{ { leader.Ends[1], leader.Ends[0] } }
                                             : Segment{ { leader.Ends[0], leader.Ends[1] } });
    for (std::size_t i = first; i < last; ++i)
    {
      curve.Sources.push_back({ segments[i].Index, segments[i].IsTurned != leader.IsTurned });
    }
    curve.SourceOffsets.push_back(static_cast<Id>(curve.Sources.size()));
    const long multiplicity = CountGroup(soup, segments, first, last, countDuplicates);
    curve.Multiplicity.push_back(static_cast<std::int16_t>(multiplicity));
    if (soup.Multiplicity.empty()) // adjacent polygons share edges
    {
      counted.Counts.DuplicateSegments += static_cast<Id>(last - first - 1);
      counted.Counts.CancelledSegments += last - first > 1 && multiplicity == 0;
    }
  }
  curve.NumberOfConstraints = curve.NumberOfSegments();
}

/** Keep the points that segments use, in the input's order. */
void CompactPoints(const SegmentSoup& soup, const Plane& plane, CountedCurve& counted)
{
  SegmentComplex& curve = counted.Curve;
  std::vector<Id> index(soup.Points.size(), None);
  for (const Segment& segment : curve.Segments)
  {
    index[segment[0]] = index[segment[1]] = 0;
  }
  for (Id p = 0; p < static_cast<Id>(soup.Points.size()); ++p)
  {
    counted.Counts.MergedPoints += counted.MergedInto[p] != p;
    if (index[p] != None)
    {
      index[p] = static_cast<Id>(curve.Points.size());
      curve.Points.push_back(plane.Project(soup.Points[p]));
      curve.Origins.push_back(PointOrigin::Input(p));
    }
  }
  for (Segment& segment : curve.Segments)
  {
    segment = { { index[segment[0]], index[segment[1]] } };
  }
}

Id NumberOfComponents(const SegmentComplex& curve)
{
  DisjointSets sets(curve.Points.size());
  for (const Segment& segment : curve.Segments)
  {
    sets.Join(segment[0], segment[1]);
  }
  Id components = 0;
  for (Id p = 0; p < static_cast<Id>(curve.Points.size()); ++p)
  {
    components += sets.Find(p) == p;
  }
  return components;
}
} // namespace

void CheckSegments(const SegmentSoup& soup)
{
  if (soup.Segments.empty())
  {
    throw Error(ErrorCode::EmptySurface, "the curve has no segments");
  }
  for (const auto& [size, name] : { std::pair(soup.Multiplicity.size(), "multiplicities"),
         std::pair(soup.NonParticipating.size(), "marks of those that do not participate") })
  {
    if (size != 0 && size != soup.Segments.size())
    {
      throw Error(ErrorCode::InvalidParameter,
        std::to_string(size) + " " + name + " are given for " +
          std::to_string(soup.Segments.size()) + " segments");
    }
  }
  const Id numberOfPoints = static_cast<Id>(soup.Points.size());
  for (std::size_t s = 0; s < soup.Segments.size(); ++s)
  {
    for (const Id p : soup.Segments[s])
    {
      if (p < 0 || p >= numberOfPoints)
      {
        throw Error(ErrorCode::PointOutOfRange,
          "segment " + std::to_string(s) + " refers to point " + std::to_string(p) + " of " +
            std::to_string(numberOfPoints));
      }
      if (!IsFinite(soup.Points[p]))
      {
        throw Error(ErrorCode::PointNotFinite, "point " + std::to_string(p) + " is not finite");
      }
    }
  }
}

Id NumberOfOpenEnds(const SegmentComplex& curve)
{
  std::vector<long> ends(curve.Points.size(), 0);
  for (Id s = 0; s < curve.NumberOfSegments(); ++s)
  {
    ends[curve.Segments[s][0]] -= curve.Multiplicity[s];
    ends[curve.Segments[s][1]] += curve.Multiplicity[s];
  }
  return static_cast<Id>(ends.size() - std::count(ends.begin(), ends.end(), 0));
}

CountedCurve CountSegments(const SegmentSoup& soup, const Plane& plane,
  const CountedChainParameters& parameters, Monitor& monitor)
{
  if (!(parameters.MergeTolerance >= 0) || std::isinf(parameters.MergeTolerance))
  {
    throw Error(ErrorCode::InvalidParameter, "MergeTolerance must be finite and at least 0");
  }
  CheckSegments(soup);
  CountedCurve counted;
  CurveCounts& counts = counted.Counts;
  counts.InputPoints = static_cast<Id>(soup.Points.size());
  counts.InputSegments = static_cast<Id>(soup.Segments.size());
  monitor.Check(Stages::Validating, 0.1);
  counted.MergedInto = MergeInPlane(soup.Points, plane, parameters.MergeTolerance);
  monitor.Check(Stages::Validating, 0.5);
  CollectSegments(soup, parameters.CountDuplicates, counted);
  if (counted.Curve.Segments.empty())
  {
    throw Error(ErrorCode::AllDegenerate,
      "all " + std::to_string(soup.Segments.size()) + " segments are degenerate (without length)");
  }
  CompactPoints(soup, plane, counted);
  counts.Points = static_cast<Id>(counted.Curve.Points.size());
  counts.Segments = counted.Curve.NumberOfSegments();
  if (soup.Multiplicity.empty())
  {
    counts.TwoSidedCurves = KeepTwoSidedCurves(soup, counted.Curve).Closed;
  }
  counts.OpenEnds = NumberOfOpenEnds(counted.Curve);
  counts.Components = NumberOfComponents(counted.Curve);
  monitor.Check(Stages::Validating, 1);
  return counted;
}

void AddCounts(const CurveCounts& counts, Statistics& statistics)
{
  statistics.emplace_back("InputPoints", counts.InputPoints);
  statistics.emplace_back("InputSegments", counts.InputSegments);
  statistics.emplace_back("Points", counts.Points);
  statistics.emplace_back("Segments", counts.Segments);
  statistics.emplace_back("OpenEnds", counts.OpenEnds);
  statistics.emplace_back("Components", counts.Components);
  statistics.emplace_back("MergedPoints", counts.MergedPoints);
  statistics.emplace_back("DegenerateSegments", counts.DegenerateSegments);
  statistics.emplace_back("DuplicateSegments", counts.DuplicateSegments);
  statistics.emplace_back("CancelledSegments", counts.CancelledSegments);
  statistics.emplace_back("TwoSidedCurves", counts.TwoSidedCurves);
}
} // namespace insideout
