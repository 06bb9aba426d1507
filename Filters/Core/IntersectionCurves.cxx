// SPDX-License-Identifier: GPL-3.0-or-later
#include "IntersectionCurves.h"

#include "ExactPoint.h"
#include "ParallelLoop.h"
#include "TrianglePredicates.h"

#include <CGAL/Simple_cartesian.h>

#include <algorithm>

namespace insideout
{
namespace
{
constexpr const char* Stage = "tracing intersections";

/** Pairs or points that a thread takes at once. */
constexpr Id BlockSize = 256;

// Every construction is wanted exactly, so that lazy evaluation would only cost.
using Rational = ExactNumber::ET;
using RationalKernel = CGAL::Simple_cartesian<Rational>;
using RationalPoint = RationalKernel::Point_3;
using RationalVector = RationalKernel::Vector_3;

RationalPoint ToRational(const Point& p)
{
  return { Rational(p[0]), Rational(p[1]), Rational(p[2]) };
}

/**
 * What a point of a curve is, so that facets around it agree without comparing coordinates: the
 * corner {p}, the edge (p, q) through the facet f {p, q, f}, or the edges (p, q) and (r, s) of one
 * plane {p, q, r, s}. None fills the rest.
 */
using CurvePoint = std::array<Id, 4>;
using CurveSegment = std::array<CurvePoint, 2>;

struct Edge
{
  Edge(Id from, Id to)
    : Low(std::min(from, to))
    , High(std::max(from, to))
  {
  }

  Id Low;
  Id High;
};

CurvePoint Corner(Id p)
{
  return { { p, None, None, None } };
}

CurvePoint Crossing(Edge edge, Id facet)
{
  return { { edge.Low, edge.High, facet, None } };
}

CurvePoint Crossing(Edge a, Edge b)
{
  if (std::tie(b.Low, b.High) < std::tie(a.Low, a.High))
  {
    std::swap(a, b);
  }
  return { { a.Low, a.High, b.Low, b.High } };
}

/** Whether a segment through the triangle's plane meets the triangle, its boundary included. */
bool Pierces(const FilteredPoint& p, const FilteredPoint& q, const FilteredTriangle& triangle)
{
  bool left = false;
  bool right = false;
  for (int k = 0; k < 3; ++k)
  {
    const CGAL::Orientation side = CGAL::orientation(p, q, triangle[k], triangle[(k + 1) % 3]);
    left = left || side == CGAL::POSITIVE;
    right = right || side == CGAL::NEGATIVE;
  }
  return !(left && right);
}

/** Finds the segments in which pairs of facets meet. */
class Tracer
{
public:
  Tracer(const std::vector<Point>& points, const std::vector<Triangle>& facets)
    : Points(points)
    , Filtered(ToFiltered(points))
    , Facets(facets)
  {
  }

  /** Adds the segments, or a point twice, that facets a and b have in common. */
  void Trace(Id a, Id b, std::vector<CurveSegment>& segments) const
  {
    const std::array<int, 3> sides = SidesOfPlane(this->Corners(a), this->Corners(b));
    if (sides[0] == 0 && sides[1] == 0 && sides[2] == 0)
    {
      this->AddEdgesWithin(a, b, segments);
      this->AddEdgesWithin(b, a, segments);
      return;
    }
    // Either end is where an edge or corner of one facet lies in the other.
    std::vector<CurvePoint> ends;
    this->AddEnds(a, b, ends);
    this->AddEnds(b, a, ends);
    this->AddSpan(ends, segments);
  }

  /** The exact place, each coordinate rounded to the nearest double. */
  Point Round(const CurvePoint& point) const
  {
    if (point[1] == None)
    {
      return this->Points[point[0]];
    }
    const RationalPoint exact = this->Locate(point);
    return { Nearest(ExactNumber(exact.x())), Nearest(ExactNumber(exact.y())),
      Nearest(ExactNumber(exact.z())) };
  }

private:
  FilteredTriangle Corners(Id facet) const
  {
    const Triangle& t = this->Facets[facet];
    return { this->Filtered[t[0]], this->Filtered[t[1]], this->Filtered[t[2]] };
  }

  /** Where corners and edges of `facet` lie in `other`, which is in another plane. */
  void AddEnds(Id facet, Id other, std::vector<CurvePoint>& ends) const
  {
    const FilteredTriangle corners = this->Corners(facet);
    const FilteredTriangle triangle = this->Corners(other);
    const std::array<int, 3> sides = SidesOfPlane(triangle, corners);
    for (int k = 0; k < 3; ++k)
    {
      const int next = (k + 1) % 3;
      if (sides[k] == 0 && ContainsInPlane(triangle, corners[k]))
      {
        ends.push_back(Corner(this->Facets[facet][k]));
      }
      else if (sides[k] * sides[next] < 0 && Pierces(corners[k], corners[next], triangle))
      {
        ends.push_back(Crossing(Edge(this->Facets[facet][k], this->Facets[facet][next]), other));
      }
    }
  }

  /** The parts of the edges of `facet` that lie in `other`, which is in the same plane. */
  void AddEdgesWithin(Id facet, Id other, std::vector<CurveSegment>& segments) const
  {
    for (int k = 0; k < 3; ++k)
    {
      this->AddEdgeWithin(
        Edge(this->Facets[facet][k], this->Facets[facet][(k + 1) % 3]), other, segments);
    }
  }

  void AddEdgeWithin(Edge edge, Id other, std::vector<CurveSegment>& segments) const
  {
    const FilteredTriangle triangle = this->Corners(other);
    const int axis = ProjectionAxis(triangle);
    const auto side = [&](Id from, Id to, Id p)
    {
      return static_cast<int>(CGAL::orientation(Project(this->Filtered[from], axis),
        Project(this->Filtered[to], axis), Project(this->Filtered[p], axis)));
    };
    std::vector<CurvePoint> ends;
    for (const Id p : { edge.Low, edge.High })
    {
      if (ContainsInPlane(triangle, this->Filtered[p]))
      {
        ends.push_back(Corner(p));
      }
    }
    const Triangle& ids = this->Facets[other];
    for (int k = 0; k < 3; ++k)
    {
      const Id from = ids[k];
      const Id to = ids[(k + 1) % 3];
      const int sideOfFrom = side(edge.Low, edge.High, from);
      const int sideOfTo = side(edge.Low, edge.High, to);
      if (side(from, to, edge.Low) * side(from, to, edge.High) < 0 && sideOfFrom * sideOfTo <= 0)
      {
        ends.push_back(sideOfFrom == 0 ? Corner(from)
            : sideOfTo == 0            ? Corner(to)
                                       : Crossing(edge, Edge(from, to)));
      }
    }
    this->AddSpan(ends, segments);
  }

  /** The segment between the outermost of points on a line. */
  void AddSpan(std::vector<CurvePoint>& ends, std::vector<CurveSegment>& segments) const
  {
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    if (ends.size() > 2)
    {
      const auto before = [&](const CurvePoint& p, const CurvePoint& q) {
        return CGAL::compare_lexicographically(this->Locate(p), this->Locate(q)) == CGAL::SMALLER;
      };
      const auto outermost = std::minmax_element(ends.begin(), ends.end(), before);
      ends = { *outermost.first, *outermost.second };
    }
    if (!ends.empty())
    {
      segments.push_back({ { ends.front(), ends.back() } });
    }
  }

  RationalPoint Locate(const CurvePoint& point) const
  {
    const RationalPoint p = ToRational(this->Points[point[0]]);
    if (point[1] == None)
    {
      return p;
    }
    const RationalPoint q = ToRational(this->Points[point[1]]);
    if (point[3] != None)
    {
      return CrossingOfLines(
        p, q, ToRational(this->Points[point[2]]), ToRational(this->Points[point[3]]));
    }
    const Triangle& facet = this->Facets[point[2]];
    const RationalPoint origin = ToRational(this->Points[facet[0]]);
    const RationalVector normal = CGAL::cross_product(
      ToRational(this->Points[facet[1]]) - origin, ToRational(this->Points[facet[2]]) - origin);
    return CrossingWithPlane(p, q, origin, normal);
  }

  /** Where the line from p to q meets that from r to s, in the same plane and not parallel. */
  static RationalPoint CrossingOfLines(
    const RationalPoint& p, const RationalPoint& q, const RationalPoint& r, const RationalPoint& s)
  {
    const RationalVector normal = CGAL::cross_product(q - p, s - r);
    return CrossingWithPlane(p, q, r, CGAL::cross_product(s - r, normal));
  }

  static RationalPoint CrossingWithPlane(const RationalPoint& p, const RationalPoint& q,
    const RationalPoint& origin, const RationalVector& normal)
  {
    const Rational height = normal * (p - origin);
    const Rational rise = normal * (q - p);
    return p - (q - p) * Rational(height / rise);
  }

  const std::vector<Point>& Points;
  const std::vector<FilteredPoint> Filtered;
  const std::vector<Triangle>& Facets;
};

/** Calls body(i) for every i in [0, count), in blocks on all threads. */
template <class Body>
void InBlocks(std::size_t count, Monitor& monitor, double begin, double end, const Body& body)
{
  const Id blocks = static_cast<Id>((count + BlockSize - 1) / BlockSize);
  ParallelLoop(blocks, monitor, { Stage, begin, end },
    [&](Id block)
    {
      const std::size_t first = static_cast<std::size_t>(block) * BlockSize;
      for (std::size_t i = first; i < std::min(first + BlockSize, count); ++i)
      {
        body(i, block);
      }
    });
}

template <typename Value>
void SortUniquely(std::vector<Value>& values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

template <typename Value>
Id IndexIn(const std::vector<Value>& sorted, const Value& value)
{
  return static_cast<Id>(std::lower_bound(sorted.begin(), sorted.end(), value) - sorted.begin());
}
} // namespace

IntersectionCurves TraceIntersections(const std::vector<Point>& points,
  const std::vector<Triangle>& facets, const std::vector<std::array<Id, 2>>& pairs,
  Monitor& monitor)
{
  monitor.Check(Stage, 0);
  const Tracer tracer(points, facets);
  std::vector<std::vector<CurveSegment>> parts((pairs.size() + BlockSize - 1) / BlockSize);
  InBlocks(pairs.size(), monitor, 0, 0.4,
    [&](std::size_t i, Id block) { tracer.Trace(pairs[i][0], pairs[i][1], parts[block]); });

  std::vector<CurvePoint> ends;
  for (const std::vector<CurveSegment>& part : parts)
  {
    for (const CurveSegment& segment : part)
    {
      ends.insert(ends.end(), segment.begin(), segment.end());
    }
  }
  SortUniquely(ends);
  std::vector<Point> places(ends.size());
  InBlocks(
    ends.size(), monitor, 0.4, 0.9, [&](std::size_t i, Id) { places[i] = tracer.Round(ends[i]); });

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
  monitor.Check(Stage, 1);
  return curves;
}
} // namespace insideout
