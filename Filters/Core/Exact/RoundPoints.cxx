// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/RoundPoints.h"

#include "Exact/EngineLimits.h"
#include "Exact/Phases.h"
#include "Exact/PointSupport.h"
#include "Exact/RoundingPlaces.h"

#include <algorithm>

namespace insideout
{
// --- Rounding ------------------------------------------------------------------------------------

std::vector<Id> PointRounder::Unrounded() const
{
  std::vector<Id> points;
  for (Id point = this->Mesh.Infinite() + 1; point < this->Mesh.Vertices().Size(); ++point)
  {
    if (!this->Mesh.Vertices().IsDouble(point) && this->Mesh.HasVertex(point))
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
    this->Progress.Check(Phases::RoundingPoints, 0);
    const std::vector<Point> places = PlacesFor(this->Mesh, this->Segments, point);
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
    this->Progress.Check(Phases::RoundingPoints, 0);
    const std::vector<Point> places = PlacesFor(this->Mesh, this->Segments, point);
    bool isRounded = false;
    for (int k = 0; k < EngineLimits::PlacesAtRandom && !isRounded; ++k)
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

// --- Out of the way ------------------------------------------------------------------------------

/** An average of the corners around a point. */
Point PointRounder::RandomPlaceInVolume(Id point, std::mt19937& random) const
{
  std::vector<Id> star;
  this->Mesh.Star(point, star);
  Point sum = { { 0, 0, 0 } };
  double weights = 0;
  for (const Id cell : star)
  {
    for (const Id corner : this->Mesh.Cell(cell).Corners)
    {
      const double weight = corner == this->Mesh.Infinite() ? 0 : static_cast<double>(random());
      const Point at = this->Mesh.Vertices().Nearest(corner);
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
  for (const Id neighbor : this->Mesh.NeighborsOf(points))
  {
    if (neighbor < this->Mesh.Infinite())
    {
      continue;
    }
    this->Progress.Check(Phases::RoundingPoints, 0);
    const PointSupport support = FindPointSupport(this->Mesh, this->Segments, neighbor);
    std::vector<Point> places;
    if (support.Segment != None)
    {
      const std::array<Id, 2> ends = this->Segments.NeighborsOnPath(support.Segment, neighbor);
      places = PlacesBetween(this->Mesh, ends[0], ends[1]);
    }
    else if (!support.Facets.empty())
    {
      continue;
    }
    bool isMoved = false;
    for (int k = 0; k < EngineLimits::PlacesPerStir && !isMoved; ++k)
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
      Tetrahedron t = this->Mesh.Cell(cell).Corners;
      t[this->Mesh.CornerIndex(cell, end)] = point;
      if (this->Mesh.IsInfinite(cell) || this->Mesh.Vertices().Orient(t[0], t[1], t[2], t[3]) <= 0)
      {
        this->Mesh.RemoveLastVertex();
        return false;
      }
    }
    const Id next = ring.Points[(k + 1) % n];
    facets.push_back(this->Mesh.Cell(cell).Facets[this->Mesh.CornerIndex(cell, next)]);
  }
  this->Mesh.SplitEdge(ring, point);
  for (std::size_t k = 0; k < n; ++k)
  {
    for (const Id end : { ring.U, ring.V })
    {
      this->Mesh.MarkFace(point, end, ring.Points[k], facets[k]);
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
      const std::vector<Point> places = PlacesBetween(this->Mesh, point, neighbor);
      EdgeRing ring;
      this->Mesh.Ring(point, neighbor, this->Mesh.FindEdge(point, neighbor), ring);
      bool isSplit = false;
      for (int k = 0; k < EngineLimits::PlacesPerStir && !isSplit; ++k)
      {
        isSplit = this->SplitAt(support.Segment, ring, places[random() % places.size()]);
      }
    }
  }
}

// --- All together --------------------------------------------------------------------------------

std::vector<Id> PointRounder::RoundAll(
  bool maySplitBeside, std::int64_t since, std::mt19937& random)
{
  const Id first = this->Mesh.Infinite() + 1;
  std::vector<Id> left = this->Round();
  std::size_t before = left.size() + 1;
  while (!left.empty() && left.size() < before)
  {
    before = left.size();
    this->Steiner.Tidy(first, since);
    left = this->Round();
  }
  int patience = EngineLimits::ShakesWithoutGain;
  bool isSplit = false;
  while (!left.empty() && patience > 0 && !this->Mesh.Work().IsUsedUp())
  {
    before = left.size();
    if (maySplitBeside && patience == EngineLimits::ShakesWithoutGain / 2)
    {
      this->SplitBeside(left, random);
      isSplit = true;
    }
    this->Stir(left, random);
    this->Steiner.Shake(left, random);
    left = this->RoundSomehow(random);
    patience = left.size() < before ? EngineLimits::ShakesWithoutGain : patience - 1;
  }
  if (isSplit && left.empty())
  {
    this->Steiner.Tidy(first, since);
    left = this->Round();
  }
  return left;
}
} // namespace insideout
