// SPDX-License-Identifier: GPL-3.0-or-later
#include "Support/PlanarLaws.h"

#include <CGAL/Exact_rational.h>
#include <quadmath.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

namespace testplanar
{
namespace
{
using Rational = CGAL::Exact_rational;
using Quad = __float128;

struct Place
{
  Rational X;
  Rational Y;
};

Place Exact(const PlanarPoint& p)
{
  return { Rational(p[0]), Rational(p[1]) };
}

Rational Turn(const Place& a, const Place& b, const Place& c)
{
  return Rational((b.X - a.X) * (c.Y - a.Y) - (b.Y - a.Y) * (c.X - a.X));
}

int Sign(const Rational& x)
{
  return (x > 0) - (x < 0);
}

/** Whether p, on the line of a and b, lies on the segment, ends included. */
bool IsBetween(const Place& a, const Place& b, const Place& p)
{
  return std::min(a.X, b.X) <= p.X && p.X <= std::max(a.X, b.X) && std::min(a.Y, b.Y) <= p.Y &&
    p.Y <= std::max(a.Y, b.Y);
}

/** Whether segments have a point in common that is not an end of both. */
bool MeetWrongly(const SegmentComplex& curve, const Segment& s, const Segment& t)
{
  const auto& points = curve.Points;
  for (int k = 0; k < 2; ++k)
  {
    const auto range = [&](const Segment& u)
    { return std::minmax(points[u[0]][k], points[u[1]][k]); };
    if (range(s).second < range(t).first || range(t).second < range(s).first)
    {
      return false;
    }
  }
  const Place a = Exact(points[s[0]]), b = Exact(points[s[1]]);
  const Place c = Exact(points[t[0]]), d = Exact(points[t[1]]);
  const int ofC = Sign(Turn(a, b, c)), ofD = Sign(Turn(a, b, d));
  const int ofA = Sign(Turn(c, d, a)), ofB = Sign(Turn(c, d, b));
  const auto isShared = [](Id p, const Segment& u) { return p == u[0] || p == u[1]; };
  return (ofC * ofD < 0 && ofA * ofB < 0) ||
    (ofC == 0 && !isShared(t[0], s) && IsBetween(a, b, c)) ||
    (ofD == 0 && !isShared(t[1], s) && IsBetween(a, b, d)) ||
    (ofA == 0 && !isShared(s[0], t) && IsBetween(c, d, a)) ||
    (ofB == 0 && !isShared(s[1], t) && IsBetween(c, d, b));
}

/** Input segments by their places, counted once per direction. */
std::map<std::array<Point, 2>, Id> FirstOfEach(const SegmentSoup& soup)
{
  std::map<std::array<Point, 2>, Id> first;
  for (std::size_t s = 0; s < soup.Segments.size(); ++s)
  {
    const std::array<Point, 2> ends{ { soup.Points[soup.Segments[s][0]],
      soup.Points[soup.Segments[s][1]] } };
    if (ends[0] != ends[1])
    {
      first.emplace(ends, static_cast<Id>(s));
    }
  }
  return first;
}

double DistanceFromLine(const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& p)
{
  const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
  return std::abs(CGAL::to_double(Turn(Exact(a), Exact(b), Exact(p)))) / length;
}
} // namespace

SegmentSoup Lines(const std::vector<PlanarPoint>& points, const std::vector<std::vector<Id>>& lines)
{
  SegmentSoup soup;
  for (const PlanarPoint& p : points)
  {
    soup.Points.push_back({ { p[0], p[1], 0 } });
  }
  for (const std::vector<Id>& line : lines)
  {
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
    {
      soup.Segments.push_back({ { line[i], line[i + 1] } });
    }
  }
  return soup;
}

SegmentSoup RandomSegments(unsigned seed, int count)
{
  std::mt19937 random(seed);
  SegmentSoup soup;
  for (Id i = 0; i < 2 * count; ++i)
  {
    const double x = random() / 4294967296.0;
    soup.Points.push_back({ { x, random() / 4294967296.0, 0 } });
  }
  for (Id i = 0; i < count; ++i)
  {
    soup.Segments.push_back({ { 2 * i, 2 * i + 1 } });
  }
  return soup;
}

SegmentSoup RandomWalk(unsigned seed, int size, int steps, bool closed)
{
  std::mt19937 random(seed);
  SegmentSoup soup;
  for (Id i = 0; i < steps; ++i)
  {
    const double x = static_cast<double>(random() % size);
    soup.Points.push_back({ { x, static_cast<double>(random() % size), 0 } });
    if (closed || i + 1 < steps)
    {
      soup.Segments.push_back({ { i, (i + 1) % steps } });
    }
  }
  return soup;
}

PlanarHull MeshHullOf(const SegmentSoup& soup, Orientation orientation)
{
  Monitor monitor;
  PlanarHullParameters parameters;
  parameters.Orientation = orientation;
  return MeshPlanarHull(soup, FindPlane(soup.Points), parameters, monitor);
}

double WindingNumberInQuads(const SegmentSoup& soup, const std::array<__float128, 2>& place)
{
  Quad sum = 0;
  for (const auto& [ends, first] : FirstOfEach(soup))
  {
    if (FirstOfEach(soup).count({ { ends[1], ends[0] } }) > 0)
    {
      continue; // they cancel
    }
    const Quad ux = ends[0][0] - place[0], uy = ends[0][1] - place[1];
    const Quad vx = ends[1][0] - place[0], vy = ends[1][1] - place[1];
    sum += atan2q(ux * vy - uy * vx, ux * vx + uy * vy);
  }
  return static_cast<double>(sum / (8 * atanq(1)));
}

std::string BrokenByResolving(const SegmentSoup& soup, const PlanarHull& hull)
{
  const SegmentComplex& curve = hull.Curve;
  const Plane& plane = hull.Plane;
  if (curve.NumberOfConstraints != curve.NumberOfSegments())
  {
    return "segments are left out";
  }
  std::set<PlanarPoint> places(curve.Points.begin(), curve.Points.end());
  if (places.size() != curve.Points.size())
  {
    return "points are there twice";
  }
  for (Id s = 0; s < curve.NumberOfSegments(); ++s)
  {
    for (Id t = 0; t < s; ++t)
    {
      if (MeetWrongly(curve, curve.Segments[s], curve.Segments[t]))
      {
        return "segments " + std::to_string(t) + " and " + std::to_string(s) + " meet";
      }
    }
  }
  // Each input segment: its pieces lead from its start to its end, and count together.
  std::vector<std::vector<Segment>> pieces(soup.Segments.size());
  std::vector<int> count(curve.Segments.size(), 0);
  std::set<Id> firsts;
  const auto firstOfEach = FirstOfEach(soup);
  for (const auto& [ends, first] : firstOfEach)
  {
    const bool cancels = firstOfEach.count({ { ends[1], ends[0] } }) > 0;
    firsts.insert(cancels ? None : first);
  }
  for (Id s = 0; s < curve.NumberOfSegments(); ++s)
  {
    for (Id i = curve.SourceOffsets[s]; i < curve.SourceOffsets[s + 1]; ++i)
    {
      const SegmentSource& source = curve.Sources[i];
      const Segment& segment = curve.Segments[s];
      pieces[source.Segment].push_back(
        source.Reversed ? Segment{ { segment[1], segment[0] } } : segment);
      count[s] += firsts.count(source.Segment) == 0 ? 0 : source.Reversed ? -1 : 1;
    }
    if (count[s] != curve.Multiplicity[s])
    {
      return "segment " + std::to_string(s) + " does not count as its sources do";
    }
  }
  for (std::size_t s = 0; s < soup.Segments.size(); ++s)
  {
    const PlanarPoint from = plane.Project(soup.Points[soup.Segments[s][0]]);
    const PlanarPoint to = plane.Project(soup.Points[soup.Segments[s][1]]);
    std::map<PlanarPoint, PlanarPoint> next;
    for (const Segment& piece : pieces[s])
    {
      next[curve.Points[piece[0]]] = curve.Points[piece[1]];
    }
    PlanarPoint at = from;
    for (std::size_t i = 0; i < next.size() && next.count(at) > 0; ++i)
    {
      at = next[at];
      if (DistanceFromLine(from, to, at) > 1e-12)
      {
        return "input segment " + std::to_string(s) + " is bent";
      }
    }
    if (next.size() != pieces[s].size() || at != to)
    {
      return "the pieces of input segment " + std::to_string(s) + " do not lead to its end";
    }
  }
  return "";
}

std::string BrokenByTriangles(const PlanarHull& hull)
{
  const auto& points = hull.Curve.Points;
  std::map<Segment, Id> opposite; // of each directed edge
  Rational area = 0;
  for (const Triangle& cell : hull.Mesh.Cells)
  {
    const Rational twice =
      Turn(Exact(points[cell[0]]), Exact(points[cell[1]]), Exact(points[cell[2]]));
    if (twice <= 0)
    {
      return "a triangle is not positive";
    }
    area += twice;
    for (int k = 0; k < 3; ++k)
    {
      if (!opposite.emplace(Segment{ { cell[k], cell[(k + 1) % 3] } }, cell[(k + 2) % 3]).second)
      {
        return "two triangles are on one side of an edge";
      }
    }
  }
  std::set<Segment> constraints;
  for (const Segment& s : hull.Curve.Segments)
  {
    const Segment back{ { s[1], s[0] } };
    constraints.insert({ s, back });
    if (opposite.count(s) == 0 && opposite.count(back) == 0)
    {
      return "a constraint is no edge";
    }
  }
  // The edges without a triangle beyond are the hull: convex, with the area of all triangles.
  Rational ofHull = 0;
  for (const auto& [edge, apex] : opposite)
  {
    const Segment back{ { edge[1], edge[0] } };
    const Place a = Exact(points[edge[0]]), b = Exact(points[edge[1]]);
    const auto beyond = opposite.find(back);
    if (beyond == opposite.end())
    {
      ofHull += a.X * b.Y - a.Y * b.X;
      for (const PlanarPoint& p : points)
      {
        if (Turn(a, b, Exact(p)) < 0)
        {
          return "the hull is not convex";
        }
      }
    }
    else if (constraints.count(edge) == 0)
    {
      const auto lifted = [&](Id p)
      {
        const Place d = Exact(points[beyond->second]);
        const Rational x = Exact(points[p]).X - d.X, y = Exact(points[p]).Y - d.Y;
        return std::array<Rational, 3>{ { x, y, Rational(x * x + y * y) } };
      };
      const auto u = lifted(edge[0]), v = lifted(edge[1]), w = lifted(apex);
      const Rational inCircle = u[0] * (v[1] * w[2] - v[2] * w[1]) -
        u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
      if (hull.Plane.Metric.IsPerpendicular() && inCircle > 0)
      {
        return "an edge is not Delaunay";
      }
    }
  }
  return area == ofHull ? "" : "the triangles do not cover the hull";
}

std::string BrokenByWindingNumbers(const SegmentSoup& soup, const PlanarHull& hull)
{
  const SegmentComplex& curve = hull.Curve;
  std::map<Segment, double> left; // w on the left of each directed edge
  std::map<Segment, int> count;
  std::map<Id, int> ends;
  for (Id s = 0; s < curve.NumberOfSegments(); ++s)
  {
    const auto& [from, to] = curve.Segments[s];
    count[{ { from, to } }] += curve.Multiplicity[s];
    count[{ { to, from } }] -= curve.Multiplicity[s];
    ends[from] -= curve.Multiplicity[s];
    ends[to] += curve.Multiplicity[s];
  }
  const bool isClosed =
    std::all_of(ends.begin(), ends.end(), [](const auto& end) { return end.second == 0; });
  const double scale = std::ldexp(1.0, hull.Plane.Exponent);
  for (std::size_t c = 0; c < hull.Mesh.Cells.size(); ++c)
  {
    std::array<Quad, 2> middle{ { 0, 0 } };
    for (int k = 0; k < 3; ++k)
    {
      const Triangle& cell = hull.Mesh.Cells[c];
      left[{ { cell[k], cell[(k + 1) % 3] } }] = hull.W[c];
      middle[0] += Quad(curve.Points[cell[k]][0]) * scale / 3;
      middle[1] += Quad(curve.Points[cell[k]][1]) * scale / 3;
    }
    const double wanted = WindingNumberInQuads(soup, middle);
    if (std::abs(hull.W[c] - wanted) > 1e-11)
    {
      return "w of cell " + std::to_string(c) + " is " + std::to_string(hull.W[c]) + ", not " +
        std::to_string(wanted);
    }
  }
  for (const auto& [edge, w] : left)
  {
    const auto right = left.find({ { edge[1], edge[0] } });
    if (isClosed && w - (right == left.end() ? 0 : right->second) != count[edge])
    {
      return "w does not jump by what an edge counts";
    }
  }
  return "";
}

std::string BrokenLaws(const SegmentSoup& soup, const PlanarHull& hull)
{
  for (const std::string& broken :
    { BrokenByResolving(soup, hull), BrokenByTriangles(hull), BrokenByWindingNumbers(soup, hull) })
  {
    if (!broken.empty())
    {
      return broken;
    }
  }
  return "";
}
} // namespace testplanar
