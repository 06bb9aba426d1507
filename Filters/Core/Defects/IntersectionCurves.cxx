// SPDX-License-Identifier: GPL-3.0-or-later
#include "Defects/IntersectionCurves.h"

#include "Common/ParallelLoop.h"
#include "Common/SortUniquely.h"
#include "Common/Stages.h"
#include "Resolve/FacetMeeting.h"

#include <algorithm>

namespace insideout
{
namespace
{
/** Pairs or points per task of a thread. */
constexpr Id BlockSize = 256;

constexpr double NanosecondsPerPair = 600; // nanoseconds to intersect two facets
constexpr double NanosecondsPerEnd = 1000; // nanoseconds to construct and round a point

using CurveSegment = std::array<ConstructedPoint, 2>;

/** Adds the common segments of two facets, or a point twice. */
void Trace(
  const FacetList& surface, const std::array<Id, 2>& pair, std::vector<CurveSegment>& segments)
{
  const Meeting meeting = Meet(surface, pair[0], pair[1]);
  if (!meeting.Overlap)
  {
    segments.push_back({ { meeting.First, meeting.Last } });
    return;
  }
  for (int i = 0; i < 2; ++i)
  {
    const std::vector<CurveSegment> edges = EdgesWithin(surface, pair[i], pair[1 - i]);
    segments.insert(segments.end(), edges.begin(), edges.end());
  }
}

/** Call body(i) for every i in [0, count), in blocks. */
template <class Body>
void InBlocks(
  std::size_t count, double cost, Monitor& monitor, double begin, double end, const Body& body)
{
  const Id blocks = static_cast<Id>((count + BlockSize - 1) / BlockSize);
  ParallelLoop(blocks, cost * BlockSize, monitor, { Stages::TracingIntersections, begin, end },
    [&](Id block)
    {
      const std::size_t first = static_cast<std::size_t>(block) * BlockSize;
      for (std::size_t i = first; i < std::min(first + BlockSize, count); ++i)
      {
        body(i, block);
      }
    });
}

} // namespace

IntersectionCurves TraceIntersections(const std::vector<Point>& points,
  const std::vector<Triangle>& facets, const std::vector<std::array<Id, 2>>& pairs,
  Monitor& monitor)
{
  monitor.Check(Stages::TracingIntersections, 0);
  const FacetList surface{ points, facets };
  std::vector<std::vector<CurveSegment>> parts((pairs.size() + BlockSize - 1) / BlockSize);
  InBlocks(pairs.size(), NanosecondsPerPair, monitor, 0, 0.4,
    [&](std::size_t i, Id block) { Trace(surface, pairs[i], parts[block]); });

  std::vector<ConstructedPoint> ends;
  for (const std::vector<CurveSegment>& part : parts)
  {
    for (const CurveSegment& segment : part)
    {
      ends.insert(ends.end(), segment.begin(), segment.end());
    }
  }
  SortUniquely(ends);
  std::vector<Point> places(ends.size());
  InBlocks(ends.size(), NanosecondsPerEnd, monitor, 0.4, 0.9,
    [&](std::size_t i, Id) { places[i] = Nearest(ends[i], surface); });

  IntersectionCurves curves;
  curves.Points = places;
  SortUniquely(curves.Points);
  for (const std::vector<CurveSegment>& part : parts)
  {
    for (const CurveSegment& segment : part)
    {
      const Id p = IndexIn(curves.Points, places[IndexIn(ends, segment[0])]);
      const Id q = IndexIn(curves.Points, places[IndexIn(ends, segment[1])]);
      if (p != q)
      {
        curves.Segments.push_back({ { std::min(p, q), std::max(p, q) } });
      }
    }
  }
  SortUniquely(curves.Segments);
  monitor.Check(Stages::TracingIntersections, 1);
  return curves;
}
} // namespace insideout
