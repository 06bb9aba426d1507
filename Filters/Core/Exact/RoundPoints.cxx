// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/RoundPoints.h"

#include "Exact/PointSupport.h"

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

/** Where many points are tried again and again, so many of their hundreds of places are. */
constexpr int PlacesAtRandom = 60;

/** Other places that are tried for a point which is in the way, or for one more. */
constexpr int MostStirs = 8;
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

/** Places all along the way between two vertices, each a little aside, too. */
std::vector<Point> PointRounder::PlacesBetween(Id u, Id v) const
{
  const Point a = this->Mesh.Vertices.Nearest(u);
  const Point b = this->Mesh.Vertices.Nearest(v);
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

/** Places for a point, the ones first that leave it nearest to what it lies on. */
std::vector<Point> PointRounder::PlacesFor(Id point) const
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
    const std::array<Id, 2> ends = this->Segments.NeighborsOnPath(segment, point);
    between = this->PlacesBetween(ends[0], ends[1]);
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
  return places;
}

/** Ascending, without the points themselves. */
std::vector<Id> PointRounder::SteinerNeighbors(const std::vector<Id>& points) const
{
  std::vector<Id> star;
  for (const Id point : points)
  {
    this->Mesh.Star(point, star);
  }
  std::vector<Id> neighbors;
  for (const Id cell : star)
  {
    for (const Id corner : this->Mesh.Cells[cell].Corners)
    {
      if (corner > this->Mesh.Infinite())
      {
        neighbors.push_back(corner);
      }
    }
  }
  std::sort(neighbors.begin(), neighbors.end());
  neighbors.erase(std::unique(neighbors.begin(), neighbors.end()), neighbors.end());
  neighbors.erase(
    std::remove_if(neighbors.begin(), neighbors.end(),
      [&points](Id p) { return std::find(points.begin(), points.end(), p) != points.end(); }),
    neighbors.end());
  return neighbors;
}

/** An average of the corners around a point. */
Point PointRounder::RandomPlaceInVolume(Id point, std::mt19937& random) const
{
  std::vector<Id> star;
  this->Mesh.Star(point, star);
  Point sum = { { 0, 0, 0 } };
  double weights = 0;
  for (const Id cell : star)
  {
    for (const Id corner : this->Mesh.Cells[cell].Corners)
    {
      const double weight = corner == this->Mesh.Infinite() ? 0 : static_cast<double>(random());
      const Point at = this->Mesh.Vertices.Nearest(corner);
      for (int k = 0; k < 3; ++k)
      {
        sum[k] += weight * at[k];
      }
      weights += weight;
    }
  }
  return { { sum[0] / weights, sum[1] / weights, sum[2] / weights } };
}

void PointRounder::Stir(const std::vector<Id>& points, std::mt19937& random)
{
  for (const Id neighbor : this->SteinerNeighbors(points))
  {
    this->Progress.Check("rounding points", 0);
    const PointSupport support = FindPointSupport(this->Mesh, this->Segments, neighbor);
    std::vector<Point> places;
    if (support.Segment != None)
    {
      const std::array<Id, 2> ends = this->Segments.NeighborsOnPath(support.Segment, neighbor);
      places = this->PlacesBetween(ends[0], ends[1]);
    }
    else if (!support.Facets.empty())
    {
      continue;
    }
    bool isMoved = false;
    for (int k = 0; k < MostStirs && !isMoved; ++k)
    {
      isMoved = this->Mover.Move(neighbor,
        places.empty() ? this->RandomPlaceInVolume(neighbor, random)
                       : places[random() % places.size()]);
    }
  }
}

/** Split a piece of a segment at a place near it, where no cell turns over. */
bool PointRounder::SplitAt(Id segment, const EdgeRing& ring, const Point& place)
{
  const Id point = this->Mesh.AddVertex(place);
  const std::size_t n = ring.Points.size();
  std::vector<Id> facets;
  for (std::size_t k = 0; k < n; ++k)
  {
    const Id cell = ring.Cells[k];
    for (const Id end : { ring.U, ring.V })
    {
      Tetrahedron t = this->Mesh.Cells[cell].Corners;
      t[this->Mesh.CornerIndex(cell, end)] = point;
      if (this->Mesh.IsInfinite(cell) || this->Mesh.Vertices.Orient(t[0], t[1], t[2], t[3]) <= 0)
      {
        this->Mesh.RemoveLastVertex();
        return false;
      }
    }
    const Id next = ring.Points[(k + 1) % n];
    facets.push_back(this->Mesh.Cells[cell].Facets[this->Mesh.CornerIndex(cell, next)]);
  }
  this->Mesh.SplitEdge(ring, point);
  for (std::size_t k = 0; k < n; ++k)
  {
    for (const Id end : { ring.U, ring.V })
    {
      Id cell;
      int face;
      if (facets[k] != None && this->Mesh.FindFace(point, end, ring.Points[k], cell, face))
      {
        this->Mesh.SetFacet(cell, face, facets[k]);
      }
    }
  }
  this->Segments.Split(segment, ring.U, ring.V, point);
  return true;
}

void PointRounder::SplitBeside(const std::vector<Id>& points, std::mt19937& random)
{
  for (const Id point : points)
  {
    const PointSupport support = FindPointSupport(this->Mesh, this->Segments, point);
    if (support.Segment == None)
    {
      continue;
    }
    for (const Id neighbor : this->Segments.NeighborsOnPath(support.Segment, point))
    {
      const std::vector<Point> places = this->PlacesBetween(point, neighbor);
      EdgeRing ring;
      this->Mesh.Ring(point, neighbor, this->Mesh.FindEdge(point, neighbor), ring);
      bool isSplit = false;
      for (int k = 0; k < MostStirs && !isSplit; ++k)
      {
        isSplit = this->SplitAt(support.Segment, ring, places[random() % places.size()]);
      }
    }
  }
}

std::vector<Id> PointRounder::Unrounded() const
{
  std::vector<Id> points;
  for (Id point = this->Mesh.Infinite() + 1; point < this->Mesh.Vertices.Size(); ++point)
  {
    if (!this->Mesh.Vertices.IsDouble(point) && this->Mesh.HasVertex(point))
    {
      points.push_back(point);
    }
  }
  return points;
}

std::vector<Id> PointRounder::Round()
{
  std::vector<Id> left;
  for (const Id point : this->Unrounded())
  {
    this->Progress.Check("rounding points", 0);
    const std::vector<Point> places = this->PlacesFor(point);
    if (std::none_of(places.begin(), places.end(),
          [&](const Point& place) { return this->Mover.Move(point, place); }))
    {
      left.push_back(point);
    }
  }
  return left;
}

std::vector<Id> PointRounder::RoundSomehow(std::mt19937& random)
{
  std::vector<Id> left;
  for (const Id point : this->Unrounded())
  {
    this->Progress.Check("rounding points", 0);
    const std::vector<Point> places = this->PlacesFor(point);
    bool isRounded = false;
    for (int k = 0; k < PlacesAtRandom && !isRounded; ++k)
    {
      isRounded = this->Mover.Move(point, places[random() % places.size()]);
    }
    if (!isRounded)
    {
      left.push_back(point);
    }
  }
  return left;
}
} // namespace insideout
