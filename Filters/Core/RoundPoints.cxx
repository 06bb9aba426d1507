// SPDX-License-Identifier: GPL-3.0-or-later
#include "RoundPoints.h"

#include "PointSupport.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
namespace
{
/** Places on a segment are tried with so many binary digits. */
constexpr int MostDigits = 52;

/** Parts of a segment between whose ends a point is tried. */
constexpr int PlacesAlong = 16;

/** Points go this much aside, in units of 2^-52 of the largest coordinate around: 1e-14 of it. */
constexpr std::array<double, 3> StepsAside = { { 1, 8, 64 } };

/** Points that are not on the surface may go farther. */
constexpr std::array<double, 7> StepsInVolume = { { 1, 8, 64, 4096, 1e6, 1e9, 1e12 } };
} // namespace

// --- Places --------------------------------------------------------------------------------------

/** Places along the segment, those first that fewer binary digits say. */
std::vector<Point> PointRounder::PlacesOnSegment(Id point, Id segment, bool exactly) const
{
  const std::array<Id, 2>& ends = this->Segments.EndsOf(segment);
  const Point a = this->Mesh.Vertices.Nearest(ends[0]);
  const Point b = this->Mesh.Vertices.Nearest(ends[1]);
  const Point now = this->Mesh.Vertices.Nearest(point);
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

/** Places all along the part of the segment that is the point's, each a little aside, too. */
std::vector<Point> PointRounder::PlacesBetweenNeighbors(Id point, Id segment) const
{
  const std::array<Id, 2> ends = this->Segments.NeighborsOnPath(segment, point);
  const Point a = this->Mesh.Vertices.Nearest(ends[0]);
  const Point b = this->Mesh.Vertices.Nearest(ends[1]);
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

/** The nearest place, and those around it. */
std::vector<Point> PointRounder::PlacesBeside(
  Id point, const double* steps, std::size_t numberOfSteps) const
{
  std::vector<Id> star;
  this->Mesh.Star(point, star);
  double largest = 0;
  for (const Id cell : star)
  {
    for (const Id corner : this->Mesh.Cells[cell].Corners)
    {
      for (const double x : this->Mesh.Vertices.Nearest(corner))
      {
        largest = std::max(largest, std::abs(x));
      }
    }
  }
  const Point nearest = this->Mesh.Vertices.Nearest(point);
  std::vector<Point> places(1, nearest);
  for (std::size_t j = 0; j < numberOfSteps; ++j)
  {
    for (int k = 0; k < 27; ++k)
    {
      const std::array<int, 3> signs = { { k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1 } };
      Point place = nearest;
      for (int axis = 0; axis < 3; ++axis)
      {
        place[axis] += signs[axis] * steps[j] * std::ldexp(largest, -52);
      }
      places.push_back(place);
    }
  }
  return places;
}

// --- All together --------------------------------------------------------------------------------

bool PointRounder::RoundOne(Id point)
{
  const PointSupport support = FindPointSupport(this->Mesh, this->Segments, point);
  const Id segment = support.Segment;
  std::vector<Point> places;
  if (segment != None)
  {
    places = this->PlacesOnSegment(point, segment, true);
  }
  std::vector<Point> between;
  if (segment != None)
  {
    between = this->PlacesBetweenNeighbors(point, segment);
  }
  const std::vector<Point> beside = support.Facets.empty() && segment == None
    ? this->PlacesBeside(point, StepsInVolume.data(), StepsInVolume.size())
    : this->PlacesBeside(point, StepsAside.data(), StepsAside.size());
  places.push_back(beside.front());
  if (segment != None)
  {
    const std::vector<Point> near = this->PlacesOnSegment(point, segment, false);
    places.insert(places.end(), near.begin(), near.end());
  }
  places.insert(places.end(), beside.begin() + 1, beside.end());
  places.insert(places.end(), between.begin(), between.end());

  return std::any_of(places.begin(), places.end(),
    [&](const Point& place) { return this->Mover.Move(point, place); });
}

std::vector<Id> PointRounder::Round()
{
  std::vector<Id> left;
  for (Id point = this->Mesh.Infinite() + 1; point < this->Mesh.Vertices.Size(); ++point)
  {
    if (!this->Mesh.Vertices.IsDouble(point) && this->Mesh.HasVertex(point))
    {
      this->Progress.Check("rounding points", 0);
      if (!this->RoundOne(point))
      {
        left.push_back(point);
      }
    }
  }
  return left;
}
} // namespace insideout
