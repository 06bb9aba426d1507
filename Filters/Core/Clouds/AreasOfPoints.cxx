// SPDX-License-Identifier: GPL-3.0-or-later
#include "Clouds/AreasOfPoints.h"

#include "Common/BoxTree.h"
#include "Common/ChunkedLoop.h"
#include "Common/Kernel.h"
#include "Common/NearestPoint.h"
#include "Common/ScaledPoints.h"
#include "Common/Vectors.h"

#include <CGAL/convex_hull_2.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

namespace insideout
{
namespace
{
// Nearest neighbors considered. A cell is exact as soon as its own neighbors, six on average, are
// among them.
constexpr std::size_t NeighboursPerPoint = 20;

using Point2 = Kernel::Point_2;

/** The points of a cloud at one place. */
struct Place
{
  Point Where;
  Point Normal; ///< the sum of their normals, or the first normal if they cancel
  std::vector<Id> Points;
};

std::vector<Place> PlacesOf(const std::vector<Point>& points, const std::vector<Point>& normals)
{
  std::vector<Id> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [&](Id a, Id b) { return points[a] != points[b] ? points[a] < points[b] : a < b; });
  std::vector<Place> places;
  for (const Id p : order)
  {
    if (places.empty() || places.back().Where != points[p])
    {
      places.push_back({ points[p], { 0, 0, 0 }, {} });
    }
    Place& place = places.back();
    place.Points.push_back(p);
    for (int axis = 0; axis < 3; ++axis)
    {
      place.Normal[axis] += normals[p][axis];
    }
  }
  for (Place& place : places)
  {
    if (Dot(place.Normal, place.Normal) == 0)
    {
      place.Normal = normals[place.Points.front()];
    }
  }
  return places;
}

std::vector<Box> BoxesOf(const std::vector<Place>& places)
{
  std::vector<Box> boxes;
  boxes.reserve(places.size());
  for (const Place& place : places)
  {
    boxes.push_back({ place.Where, place.Where });
  }
  return boxes;
}

/** Differences from a place to its nearest neighbors that face the same way; ties: the lowest. */
std::vector<Point> ToNeighbours(const std::vector<Place>& places, const BoxTree& tree, Id place)
{
  const Place& self = places[place];
  std::vector<std::pair<double, Id>> nearest; // a heap, the farthest first
  tree.VisitNearestFirst([&](const Box& box) { return SquaredDistance(box, self.Where); },
    [&]
    {
      return nearest.size() < NeighboursPerPoint ? std::numeric_limits<double>::infinity()
                                                 : nearest.front().first;
    },
    [&](Id other)
    {
      if (other == place || Dot(places[other].Normal, self.Normal) <= 0)
      {
        return;
      }
      const Point& where = places[other].Where;
      nearest.emplace_back(SquaredDistance(Box{ where, where }, self.Where), other);
      std::push_heap(nearest.begin(), nearest.end());
      if (nearest.size() > NeighboursPerPoint)
      {
        std::pop_heap(nearest.begin(), nearest.end());
        nearest.pop_back();
      }
    });
  std::vector<Point> differences;
  for (const auto& neighbour : nearest)
  {
    differences.push_back(Difference(places[neighbour.second].Where, self.Where));
  }
  return differences;
}

/** Coordinates in the plane perpendicular to a normal of any length. */
std::vector<Point2> InTangentPlane(const std::vector<Point>& vectors, const Point& normal)
{
  int least = 0;
  for (int axis = 1; axis < 3; ++axis)
  {
    least = std::abs(normal[axis]) < std::abs(normal[least]) ? axis : least;
  }
  Point axis = { 0, 0, 0 };
  axis[least] = 1;
  const Point u = Cross(normal, axis);
  const Point v = Cross(normal, u);
  const double lengthU = Length(u);
  const double lengthV = Length(v);
  std::vector<Point2> flat;
  flat.reserve(vectors.size());
  for (const Point& vector : vectors)
  {
    flat.emplace_back(Dot(vector, u) / lengthU, Dot(vector, v) / lengthV);
  }
  return flat;
}

/** The part of a convex polygon nearer to the origin than to `other`. */
std::vector<Point2> NearerPart(const std::vector<Point2>& polygon, const Point2& other)
{
  const double half = (other.x() * other.x() + other.y() * other.y()) / 2;
  const auto beyond = [&](const Point2& p) { return p.x() * other.x() + p.y() * other.y() - half; };
  std::vector<Point2> part;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point2& a = polygon[i];
    const Point2& b = polygon[(i + 1) % polygon.size()];
    const double ofA = beyond(a);
    const double ofB = beyond(b);
    if (ofA <= 0)
    {
      part.push_back(a);
    }
    if ((ofA < 0 && ofB > 0) || (ofA > 0 && ofB < 0))
    {
      const double t = ofA / (ofA - ofB);
      part.emplace_back(a.x() + t * (b.x() - a.x()), a.y() + t * (b.y() - a.y()));
    }
  }
  return part;
}

double AreaOf(const std::vector<Point2>& polygon)
{
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point2& a = polygon[i];
    const Point2& b = polygon[(i + 1) % polygon.size()];
    twice += a.x() * b.y() - b.x() * a.y();
  }
  return std::max(twice / 2, 0.0);
}

/** The area of the origin's Voronoi cell among its neighbors, within the convex hull of all. */
double AreaOfCell(const std::vector<Point2>& neighbours)
{
  std::vector<Point2> all = neighbours;
  all.emplace_back(0, 0);
  std::vector<Point2> cell;
  CGAL::convex_hull_2(all.begin(), all.end(), std::back_inserter(cell));
  for (const Point2& other : neighbours)
  {
    cell = NearerPart(cell, other);
  }
  return AreaOf(cell);
}
} // namespace

std::vector<double> AreasOfPoints(const std::vector<Point>& points,
  const std::vector<Point>& normals, Monitor& monitor, const ProgressRange& progress)
{
  const int exponent = LargestExponent(points);
  const std::vector<Place> places = PlacesOf(ScaledPoints(points, -exponent), normals);
  const BoxTree tree(BoxesOf(places));
  std::vector<double> areas(points.size());
  const double nanosecondsPerPlace = 10000;
  ChunkedLoop(static_cast<Id>(places.size()), nanosecondsPerPlace, monitor, progress,
    [&](Id place)
    {
      const Place& here = places[place];
      const double area =
        AreaOfCell(InTangentPlane(ToNeighbours(places, tree, place), here.Normal));
      for (const Id p : here.Points)
      {
        areas[p] = std::ldexp(area / static_cast<double>(here.Points.size()), 2 * exponent);
      }
    });
  return areas;
}
} // namespace insideout
