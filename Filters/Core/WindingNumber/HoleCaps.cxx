// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/HoleCaps.h"

#include "Common/PointPredicates.h"
#include "Common/SortUniquely.h"
#include "Common/SortedTriangle.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <limits>

namespace insideout
{
namespace
{
// Corners of a long loop that are tried, evenly spread.
constexpr std::size_t MostApexes = 16;

// Edges per arc of a longer loop: with many small fans, few are near any given place.
constexpr std::size_t EdgesPerArc = 32;

Triangle FanTriangle(const Loop& loop, std::size_t apex, std::size_t i)
{
  const std::size_t size = loop.size();
  return { loop[apex], loop[(apex + i) % size], loop[(apex + i + 1) % size] };
}

std::size_t BestApex(const std::vector<Point>& points, const Loop& loop)
{
  std::size_t best = 0;
  double leastArea = std::numeric_limits<double>::infinity();
  const std::size_t step = 1 + (loop.size() - 1) / MostApexes;
  for (std::size_t apex = 0; loop.size() > 3 && apex < loop.size(); apex += step)
  {
    double area = 0;
    for (std::size_t i = 1; i + 1 < loop.size(); ++i)
    {
      const Triangle t = FanTriangle(loop, apex, i);
      area += Length(NormalOf(points[t[0]], points[t[1]], points[t[2]]));
    }
    if (area < leastArea)
    {
      leastArea = area;
      best = apex;
    }
  }
  return best;
}

/** The non-degenerate triangles of the fan from the best corner. */
std::vector<CountedTriangle> Fan(const std::vector<Point>& points, const Loop& loop)
{
  const std::size_t apex = BestApex(points, loop);
  std::vector<CountedTriangle> fan;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
  {
    const Triangle triangle = FanTriangle(loop, apex, i);
    if (!IsDegenerate(points, triangle))
    {
      fan.push_back({ triangle, 1 });
    }
  }
  return fan;
}

/** Make a cap for each arc and its chord. @return the loop of the chords */
Loop CutOffArcs(const std::vector<Point>& points, const Loop& loop,
  std::vector<std::vector<CountedTriangle>>& caps)
{
  Loop chords;
  for (std::size_t first = 0; first < loop.size(); first += EdgesPerArc)
  {
    const std::size_t last = std::min(first + EdgesPerArc, loop.size());
    Loop arc(loop.begin() + static_cast<std::ptrdiff_t>(first),
      loop.begin() + static_cast<std::ptrdiff_t>(last));
    arc.push_back(loop[last % loop.size()]);
    chords.push_back(arc.front());
    if (arc.size() > 2)
    {
      caps.push_back(Fan(points, arc));
    }
  }
  return chords;
}
} // namespace

std::vector<std::vector<CountedTriangle>> CapHoles(
  const std::vector<Point>& points, const std::vector<CountedEdge>& boundary)
{
  std::vector<std::vector<CountedTriangle>> caps;
  for (Loop loop : LoopsOf(boundary))
  {
    while (loop.size() >= 2 * EdgesPerArc)
    {
      loop = CutOffArcs(points, loop, caps);
    }
    caps.push_back(Fan(points, loop));
  }
  return caps;
}

std::vector<std::vector<CountedTriangle>> NumberedCaps::InIds() const
{
  std::vector<std::vector<CountedTriangle>> caps = this->Caps;
  for (std::vector<CountedTriangle>& cap : caps)
  {
    for (CountedTriangle& triangle : cap)
    {
      for (Id& corner : triangle.Corners)
      {
        corner = this->Ids[corner];
      }
    }
  }
  return caps;
}

NumberedCaps CapHolesInOrder(
  const std::vector<Point>& points, const std::vector<CountedEdge>& boundary)
{
  NumberedCaps numbered;
  std::vector<Id>& ids = numbered.Ids;
  for (const CountedEdge& edge : boundary)
  {
    ids.insert(ids.end(), { edge.From, edge.To });
  }
  SortUniquely(ids);
  std::sort(ids.begin(), ids.end(), [&](Id a, Id b) { return points[a] < points[b]; });
  for (const Id p : ids)
  {
    numbered.Points.push_back(points[p]);
  }
  std::vector<CountedEdge> edges;
  edges.reserve(boundary.size());
  for (const CountedEdge& edge : boundary)
  {
    const Id from = IndexIn(numbered.Points, points[edge.From]);
    const Id to = IndexIn(numbered.Points, points[edge.To]);
    edges.push_back(
      from < to ? CountedEdge{ from, to, edge.Count } : CountedEdge{ to, from, -edge.Count });
  }
  std::sort(edges.begin(), edges.end(),
    [](const CountedEdge& a, const CountedEdge& b)
    { return a.From != b.From ? a.From < b.From : a.To < b.To; });
  numbered.Caps = CapHoles(numbered.Points, edges);
  return numbered;
}

std::vector<CountedTriangle> MergeTriangles(const std::vector<CountedTriangle>& triangles)
{
  std::vector<CountedTriangle> sorted;
  sorted.reserve(triangles.size());
  for (const CountedTriangle& triangle : triangles)
  {
    const SortedTriangle corners(triangle.Corners);
    sorted.push_back({ corners.Points, corners.Turned ? -triangle.Count : triangle.Count });
  }
  std::sort(sorted.begin(), sorted.end(),
    [](const CountedTriangle& a, const CountedTriangle& b) { return a.Corners < b.Corners; });
  std::vector<CountedTriangle> sum;
  for (std::size_t first = 0, next = 0; first < sorted.size(); first = next)
  {
    CountedTriangle one = { sorted[first].Corners, 0 };
    for (; next < sorted.size() && sorted[next].Corners == one.Corners; ++next)
    {
      one.Count += sorted[next].Count;
    }
    if (one.Count != 0)
    {
      sum.push_back(one);
    }
  }
  return sum;
}

std::vector<CountedTriangle> CloseChain(
  std::vector<CountedTriangle> triangles, const std::vector<std::vector<CountedTriangle>>& caps)
{
  if (caps.empty())
  {
    return triangles;
  }
  // Only a triangle between corners of caps can coincide with one of a cap.
  std::vector<CountedTriangle> between;
  Id last = -1;
  for (const std::vector<CountedTriangle>& cap : caps)
  {
    for (const CountedTriangle& triangle : cap)
    {
      between.push_back({ triangle.Corners, -triangle.Count });
      last = std::max({ last, triangle.Corners[0], triangle.Corners[1], triangle.Corners[2] });
    }
  }
  std::vector<char> isCorner(static_cast<std::size_t>(last) + 1, 0);
  for (const CountedTriangle& triangle : between)
  {
    for (const Id p : triangle.Corners)
    {
      isCorner[p] = 1;
    }
  }
  std::vector<CountedTriangle> closed;
  closed.reserve(triangles.size() + between.size());
  for (const CountedTriangle& triangle : triangles)
  {
    const bool isBetween = std::all_of(triangle.Corners.begin(), triangle.Corners.end(),
      [&](Id p) { return p <= last && isCorner[p]; });
    (isBetween ? between : closed).push_back(triangle);
  }
  const std::vector<CountedTriangle> sum = MergeTriangles(between);
  closed.insert(closed.end(), sum.begin(), sum.end());
  return closed;
}
} // namespace insideout
