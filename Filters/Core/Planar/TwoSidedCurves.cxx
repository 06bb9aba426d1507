// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/TwoSidedCurves.h"

#include "Common/Buckets.h"
#include "Common/DisjointSets.h"

namespace insideout
{
namespace
{
/** Directions of a segment's participating sources. */
enum class Directions
{
  None,
  One,
  Both ///< and cancel
};

Directions DirectionsOf(const SegmentSoup& soup, const SegmentComplex& curve, Id segment)
{
  std::array<bool, 2> isGiven{ { false, false } };
  for (Id i = curve.SourceOffsets[segment]; i < curve.SourceOffsets[segment + 1]; ++i)
  {
    const auto& [source, isReversed] = curve.Sources[i];
    if (soup.NonParticipating.empty() || soup.NonParticipating[source] == 0)
    {
      isGiven[isReversed ? 1 : 0] = true;
    }
  }
  // With duplicates counted, one direction may occur more often than the other.
  return isGiven[0] && isGiven[1] && curve.Multiplicity[segment] == 0 ? Directions::Both
    : isGiven[0] || isGiven[1]                                        ? Directions::One
                                                                      : Directions::None;
}

/** The segments of components whose participating segments were all given in both directions. */
std::vector<Id> TwoSidedSegments(const SegmentSoup& soup, const SegmentComplex& curve)
{
  std::vector<Directions> directions;
  DisjointSets sets(curve.Points.size());
  for (Id s = 0; s < curve.NumberOfSegments(); ++s)
  {
    directions.push_back(DirectionsOf(soup, curve, s));
    if (directions.back() != Directions::None)
    {
      sets.Join(curve.Segments[s][0], curve.Segments[s][1]);
    }
  }
  std::vector<char> isOneSided(curve.Points.size(), 0); // by the sets' first points
  for (Id s = 0; s < curve.NumberOfSegments(); ++s)
  {
    if (directions[s] == Directions::One)
    {
      isOneSided[sets.Find(curve.Segments[s][0])] = 1;
    }
  }
  std::vector<Id> found;
  for (Id s = 0; s < curve.NumberOfSegments(); ++s)
  {
    if (directions[s] == Directions::Both && !isOneSided[sets.Find(curve.Segments[s][0])])
    {
      found.push_back(s);
    }
  }
  return found;
}

/** A segment in a chain, and its direction relative to the chain. */
struct Link
{
  Id Segment;
  bool IsAlong;
};

/** Twice the signed area of a closed chain, in the coordinates' own measure. */
double TwiceAreaOf(const SegmentComplex& curve, const std::vector<Link>& chain)
{
  const PlanarPoint& origin = curve.Points[curve.Segments[chain.front().Segment][0]];
  double area = 0;
  for (const Link& link : chain)
  {
    const auto& [from, to] = curve.Segments[link.Segment];
    area += (link.IsAlong ? 2 : -2) *
      AreaOf(origin, curve.Points[from], curve.Points[to], PlanarMetric());
  }
  return area;
}
} // namespace

TwoSidedCurves KeepTwoSidedCurves(const SegmentSoup& soup, SegmentComplex& curve)
{
  const std::vector<Id> segments = TwoSidedSegments(soup, curve);
  const Buckets<Id> around(curve.Points.size(),
    [&](auto visit)
    {
      for (const Id s : segments)
      {
        visit(static_cast<std::size_t>(curve.Segments[s][0]), s);
        visit(static_cast<std::size_t>(curve.Segments[s][1]), s);
      }
    });
  std::vector<char> isTaken(curve.Segments.size(), 0);
  // Trace from a point along a segment to the end of the chain.
  const auto follow = [&](Id point, Id segment, std::vector<Link>& chain)
  {
    while (!isTaken[segment])
    {
      isTaken[segment] = 1;
      const bool isAlong = curve.Segments[segment][0] == point;
      chain.push_back({ segment, isAlong });
      point = curve.Segments[segment][isAlong ? 1 : 0];
      if (around[point].Size() == 2)
      {
        const auto two = around[point];
        segment = *two.begin() == segment ? *(two.begin() + 1) : *two.begin();
      }
    }
    return point;
  };
  TwoSidedCurves result;
  const auto keep = [&](Id start, Id segment)
  {
    std::vector<Link> chain;
    const double area = follow(start, segment, chain) == start ? TwiceAreaOf(curve, chain) : 0;
    for (const Link& link : chain)
    {
      curve.Multiplicity[link.Segment] = static_cast<std::int16_t>(area == 0 ? 0
          : link.IsAlong == (area > 0)                                       ? 1
                                                                             : -1);
    }
    result.Closed += area != 0;
    result.Sheets += area == 0;
  };
  for (const Id s : segments) // chains that begin at points of more or fewer than two segments
  {
    for (const Id point : curve.Segments[s])
    {
      if (!isTaken[s] && around[point].Size() != 2)
      {
        keep(point, s);
      }
    }
  }
  for (const Id s : segments) // rings
  {
    if (!isTaken[s])
    {
      keep(curve.Segments[s][0], s);
    }
  }
  return result;
}
} // namespace insideout
