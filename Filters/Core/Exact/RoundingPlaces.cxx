// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/RoundingPlaces.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
namespace
{
/** Limit of binary digits of a position on a segment: a double has no more. */
constexpr int MostDigits = 52;

/** Number of parts of a segment whose ends are candidates. */
constexpr int PlacesAlong = 16;

/** Shifts of points, in units of 2^-52 of the largest coordinate nearby: up to 1e-14 of it. */
constexpr std::array<double, 3> StepsAside = { { 1, 8, 64 } };

/** Points that are not on the surface may go farther. */
constexpr std::array<double, 2> StepsInVolume = { { 1, 1e12 } };

/** Places along the segment, those with the fewest binary digits first. */
std::vector<Point> PlacesOnSegment(
  const FlippableMesh& mesh, const std::array<Id, 2>& ends, Id point, bool exactly)
{
  const Point a = mesh.Vertices().Nearest(ends[0]);
  const Point b = mesh.Vertices().Nearest(ends[1]);
  const Point now = mesh.Vertices().Nearest(point);
  int axis = 0;
  for (int k = 1; k < 3; ++k)
  {
    axis = std::abs(b[k] - a[k]) > std::abs(b[axis] - a[axis]) ? k : axis;
  }
  const double share = (now[axis] - a[axis]) / (b[axis] - a[axis]);
  std::vector<Point> places;
  double last = -1;
  for (int digits = 1; digits <= MostDigits; ++digits)
  {
    const double t = std::ldexp(std::nearbyint(std::ldexp(share, digits)), -digits);
    if (!(t > 0 && t < 1) || t == last)
    {
      continue;
    }
    last = t;
    Point place;
    bool isExact = true;
    for (int k = 0; k < 3; ++k)
    {
      place[k] = a[k] + t * (b[k] - a[k]);
      isExact = isExact &&
        DyadicNumber(place[k]) ==
          DyadicNumber(a[k]) + DyadicNumber(t) * (DyadicNumber(b[k]) - DyadicNumber(a[k]));
    }
    if (isExact == exactly)
    {
      places.push_back(place);
    }
  }
  return places;
}

/** The nearest place, then those around it. */
template <std::size_t Size>
std::vector<Point> PlacesBeside(
  const FlippableMesh& mesh, Id point, const std::array<double, Size>& steps)
{
  std::vector<Id> star;
  mesh.Star(point, star);
  double largest = 0;
  for (const Id cell : star)
  {
    for (const Id corner : mesh.Cell(cell).Corners)
    {
      for (const double x : mesh.Vertices().Nearest(corner))
      {
        largest = std::max(largest, std::abs(x));
      }
    }
  }
  const Point nearest = mesh.Vertices().Nearest(point);
  std::vector<Point> places(1, nearest);
  for (const double step : steps)
  {
    for (int k = 0; k < 27; ++k)
    {
      const std::array<int, 3> signs = { { k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1 } };
      Point place = nearest;
      for (int axis = 0; axis < 3; ++axis)
      {
        place[axis] += signs[axis] * step * std::ldexp(largest, -52);
      }
      places.push_back(place);
    }
  }
  return places;
}

/** Places all along the line between two vertices, each also slightly shifted. */
std::vector<Point> PlacesBetween(const FlippableMesh& mesh, Id u, Id v)
{
  const Point a = mesh.Vertices().Nearest(u);
  const Point b = mesh.Vertices().Nearest(v);
  double largest = 0;
  for (int k = 0; k < 3; ++k)
  {
    largest = std::max({ largest, std::abs(a[k]), std::abs(b[k]) });
  }
  std::vector<Point> places;
  for (int j = 1; j < PlacesAlong; ++j)
  {
    for (int k = 0; k < 27; ++k)
    {
      const std::array<int, 3> signs = { { (k + 1) % 3 - 1, (k / 3 + 1) % 3 - 1,
        (k / 9 + 1) % 3 - 1 } };
      Point place;
      for (int axis = 0; axis < 3; ++axis)
      {
        place[axis] = a[axis] + static_cast<double>(j) / PlacesAlong * (b[axis] - a[axis]) +
          signs[axis] * std::ldexp(largest, -52);
      }
      places.push_back(place);
    }
  }
  return places;
}
} // namespace

std::vector<Point> PlacesFor(const ExactState& state, Id point)
{
  const FlippableMesh& mesh = state.Mesh;
  const SegmentTable& segments = state.Segments;
  const PointSupport support = state.SupportOf(point);
  const Id segment = support.Segment;
  std::vector<Point> places;
  std::vector<Point> between;
  if (segment != None)
  {
    places = PlacesOnSegment(mesh, segments.EndsOf(segment), point, true);
    const std::array<Id, 2> ends = segments.NeighborsOnPath(segment, point);
    between = PlacesBetween(mesh, ends[0], ends[1]);
  }
  const std::vector<Point> beside = support.IsNothing() ? PlacesBeside(mesh, point, StepsInVolume)
                                                        : PlacesBeside(mesh, point, StepsAside);
  places.push_back(beside.front());
  if (segment != None)
  {
    const std::vector<Point> near = PlacesOnSegment(mesh, segments.EndsOf(segment), point, false);
    places.insert(places.end(), near.begin(), near.end());
  }
  places.insert(places.end(), beside.begin() + 1, beside.end());
  places.insert(places.end(), between.begin(), between.end());
  return places;
}
} // namespace insideout
