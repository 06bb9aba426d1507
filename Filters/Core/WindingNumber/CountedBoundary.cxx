// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/CountedBoundary.h"

#include "Common/Buckets.h"
#include "Common/ParallelLoop.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <unordered_map>

namespace insideout
{
namespace
{
/** Half of an edge's record: the bucket of its lower point implies the rest. */
struct HigherEnd
{
  Id High;
  int Count;
};

constexpr double NanosecondsPerTriangle = 35; // mostly for sorting the edges into buckets

/** The edges whose lower point is in a range, bucketed by that point. */
Buckets<HigherEnd> EdgesByLowerPoint(
  const std::vector<CountedTriangle>& triangles, Id first, Id last)
{
  return { static_cast<std::size_t>(last - first),
    [&](auto visit)
    {
      for (const CountedTriangle& triangle : triangles)
      {
        for (int k = 0; k < 3; ++k)
        {
          const Id from = triangle.Corners[k];
          const Id to = triangle.Corners[(k + 1) % 3];
          const Id low = std::min(from, to);
          if (low >= first && low < last)
          {
            visit(static_cast<std::size_t>(low - first),
              HigherEnd{ std::max(from, to), from < to ? triangle.Count : -triangle.Count });
          }
        }
      }
    } };
}

/** The part of the boundary whose lower points are in a range. */
std::vector<CountedEdge> PartOfBoundary(
  const std::vector<CountedTriangle>& triangles, Id first, Id last)
{
  Buckets<HigherEnd> edges = EdgesByLowerPoint(triangles, first, last);
  std::vector<CountedEdge> boundary;
  for (std::size_t bucket = 0; bucket < edges.Size(); ++bucket)
  {
    edges.Sort(bucket, [](const HigherEnd& a, const HigherEnd& b) { return a.High < b.High; });
    const Buckets<HigherEnd>::Range ends = edges[bucket];
    for (const HigherEnd* edge = ends.First; edge != ends.Last;)
    {
      CountedEdge sum = { first + static_cast<Id>(bucket), edge->High, 0 };
      for (; edge != ends.Last && edge->High == sum.To; ++edge)
      {
        sum.Count += edge->Count;
      }
      if (sum.Count != 0)
      {
        boundary.push_back(sum);
      }
    }
  }
  return boundary;
}
} // namespace

std::vector<CountedTriangle> CountedFacets(const FacetComplex& surface)
{
  std::vector<CountedTriangle> counted;
  counted.reserve(surface.Facets.size());
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    if (surface.Multiplicity[f] != 0)
    {
      counted.push_back({ surface.Facets[f], surface.Multiplicity[f] });
    }
  }
  return counted;
}

std::vector<Point> CentresOf(
  const std::vector<Point>& points, const std::vector<CountedTriangle>& triangles)
{
  std::vector<Point> centres;
  centres.reserve(triangles.size());
  for (const CountedTriangle& triangle : triangles)
  {
    const auto [a, b, c] = CornersOf(points, triangle.Corners);
    Point& centre = centres.emplace_back();
    for (int axis = 0; axis < 3; ++axis)
    {
      centre[axis] = a[axis] / 3 + b[axis] / 3 + c[axis] / 3;
    }
  }
  return centres;
}

std::vector<CountedEdge> CountedBoundary(
  const std::vector<CountedTriangle>& triangles, Id numberOfPoints)
{
  // As many ranges as threads, because each thread reads all triangles.
  const int parts = TeamSize(NanosecondsPerTriangle * static_cast<double>(triangles.size()));
  std::vector<std::vector<CountedEdge>> found(static_cast<std::size_t>(parts));
  const auto beginOf = [&](int part)
  { return static_cast<Id>(static_cast<std::int64_t>(numberOfPoints) * part / parts); };
  ParallelLoop(parts, NanosecondsPerTriangle * static_cast<double>(triangles.size()),
    [&](int part) { found[part] = PartOfBoundary(triangles, beginOf(part), beginOf(part + 1)); });
  std::vector<CountedEdge> boundary = std::move(found.front());
  for (int part = 1; part < parts; ++part)
  {
    boundary.insert(boundary.end(), found[part].begin(), found[part].end());
  }
  return boundary;
}

std::vector<Loop> LoopsOf(const std::vector<CountedEdge>& boundary)
{
  std::unordered_map<Id, std::vector<Id>> successors;
  std::vector<Id> starts;
  for (const CountedEdge& edge : boundary)
  {
    const Id from = edge.Count > 0 ? edge.From : edge.To;
    const Id to = edge.Count > 0 ? edge.To : edge.From;
    for (std::int64_t i = 0; i < std::abs(edge.Count); ++i)
    {
      successors[from].push_back(to);
    }
    starts.push_back(from);
  }

  std::vector<Loop> loops;
  std::unordered_map<Id, std::size_t> place; // of the points on the current walk
  for (const Id start : starts)
  {
    std::vector<Id> walk = { start };
    while (!successors[walk.back()].empty())
    {
      const Id here = walk.back();
      const Id next = successors[here].back();
      successors[here].pop_back();
      place[here] = walk.size() - 1;
      const auto seen = place.find(next);
      if (seen == place.end())
      {
        walk.push_back(next);
        continue;
      }
      // Split off the loop that was just closed, and continue from its start.
      const std::size_t first = seen->second;
      loops.emplace_back(walk.begin() + static_cast<std::ptrdiff_t>(first), walk.end());
      for (std::size_t i = first; i < walk.size(); ++i)
      {
        place.erase(walk[i]);
      }
      walk.resize(first + 1);
    }
    place.clear();
  }
  return loops;
}
} // namespace insideout
