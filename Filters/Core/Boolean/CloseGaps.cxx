// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/CloseGaps.h"

#include "Common/BoxTree.h"
#include "Common/LoopProgress.h"
#include "Common/Stages.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

namespace insideout
{
namespace
{
/**
 * Sines of angles: the plane of a facet thinner than this is unreliable, and planes at an angle
 * below the second move a point to the same place.
 */
constexpr double Thinnest = 1e-8;
constexpr double Parallel = 0.05;

struct Facet
{
  Id Body;
  Triangle Corners;
};

struct Plane
{
  Point Origin;
  Point Normal; ///< of length 1
};

double HeightOver(const Plane& plane, const Point& p)
{
  return Dot(plane.Normal, Difference(p, plane.Origin));
}

std::optional<Plane> PlaneOf(const std::array<Point, 3>& facet)
{
  const auto unit = [](Point v)
  {
    const double length = Length(v);
    return Point{ v[0] / length, v[1] / length, v[2] / length };
  };
  const Point normal =
    Cross(unit(Difference(facet[1], facet[0])), unit(Difference(facet[2], facet[0])));
  if (!(Length(normal) > Thinnest)) // also excludes edges without length
  {
    return std::nullopt;
  }
  return Plane{ facet[0], unit(normal) };
}

/**
 * Whether two triangles overlap, seen along the normal of the first, by more than a strip: no line
 * along an edge of either separates them (the separating axis theorem in two dimensions).
 */
bool AreAboveEachOther(const std::array<Point, 3>& first, const std::array<Point, 3>& second,
  const Point& normal, double strip)
{
  for (const auto* edges : { &first, &second })
  {
    for (int k = 0; k < 3; ++k)
    {
      const Point across = Cross(normal, Difference((*edges)[(k + 1) % 3], (*edges)[k]));
      const double length = Length(across);
      const auto range = [&](const std::array<Point, 3>& triangle)
      {
        const auto along = [&](int i)
        { return Dot(across, Difference(triangle[i], first[0])) / length; };
        return std::minmax({ along(0), along(1), along(2) });
      };
      const auto [low, high] = range(first);
      const auto [otherLow, otherHigh] = range(second);
      if (!(std::min(high, otherHigh) - std::max(low, otherLow) > strip))
      {
        return false;
      }
    }
  }
  return true;
}

/** The nearest place in all planes, without those nearly parallel to others. */
Point MovedInto(const std::vector<Plane>& planes, const Point& p)
{
  std::vector<Point> axes;
  Point moved = p;
  for (const Plane& plane : planes)
  {
    Point axis = plane.Normal;
    for (const Point& other : axes)
    {
      const double part = Dot(other, axis);
      for (int i = 0; i < 3; ++i)
      {
        axis[i] -= part * other[i];
      }
    }
    const double length = Length(axis);
    if (length < Parallel)
    {
      continue;
    }
    for (double& coordinate : axis)
    {
      coordinate /= length;
    }
    const double by = HeightOver(plane, moved) / Dot(plane.Normal, axis);
    for (int i = 0; i < 3; ++i)
    {
      moved[i] -= by * axis[i];
    }
    axes.push_back(axis);
  }
  return moved;
}

class GapCloser
{
public:
  GapCloser(std::vector<Body>& bodies, double tolerance, Monitor& monitor)
    : Bodies(bodies)
    , Tolerance(tolerance)
    , Watch(monitor)
    , Facets(FacetsOf(bodies))
    , Tree(this->BoxesOfFacets())
  {
  }

  Id CloseAll();

private:
  using Places = std::map<Point, std::vector<Plane>>;

  static std::vector<Facet> FacetsOf(const std::vector<Body>& bodies);
  std::vector<Box> BoxesOfFacets() const;
  std::array<Point, 3> CornersOf(const Facet& facet) const
  {
    return insideout::CornersOf(this->Bodies[facet.Body].Soup.Points, facet.Corners);
  }
  Box BoxAround(const Facet& facet) const
  {
    return BoundingBox(this->Bodies[facet.Body].Soup.Points, facet.Corners)
      .Widened(this->Tolerance);
  }
  void FindPlanes(const Facet& facet, Places& places) const;
  Id Move(const Places& places, Body& body) const;

  std::vector<Body>& Bodies;
  const double Tolerance;
  Monitor& Watch;
  const std::vector<Facet> Facets; ///< those with a plane, by body
  const BoxTree Tree;
  std::set<Point> Fixed; ///< positions of the points of earlier bodies
};

std::vector<Facet> GapCloser::FacetsOf(const std::vector<Body>& bodies)
{
  std::vector<Facet> facets;
  for (std::size_t b = 0; b < bodies.size(); ++b)
  {
    const std::vector<Point>& points = bodies[b].Soup.Points;
    for (const Triangle& corners : bodies[b].Soup.Triangles)
    {
      if (std::all_of(corners.begin(), corners.end(),
            [&](Id p)
            { return p >= 0 && p < static_cast<Id>(points.size()) && IsFinite(points[p]); }) &&
        PlaneOf(insideout::CornersOf(points, corners)))
      {
        facets.push_back({ static_cast<Id>(b), corners });
      }
    }
  }
  return facets;
}

/** A box per facet: around the facet and all positions that it may move to. */
std::vector<Box> GapCloser::BoxesOfFacets() const
{
  std::vector<Box> boxes;
  for (const Facet& facet : this->Facets)
  {
    boxes.push_back(this->BoxAround(facet));
  }
  return boxes;
}

/** The planes of facets of earlier bodies into which the corners of a facet are moved. */
void GapCloser::FindPlanes(const Facet& facet, Places& places) const
{
  const std::array<Point, 3> corners = this->CornersOf(facet);
  this->Tree.Visit(this->BoxAround(facet),
    [&](Id other)
    {
      if (this->Facets[other].Body >= facet.Body)
      {
        return;
      }
      const std::array<Point, 3> others = this->CornersOf(this->Facets[other]);
      const std::optional<Plane> plane = PlaneOf(others);
      const auto isNear = [&](const Point& p)
      { return std::abs(HeightOver(*plane, p)) <= this->Tolerance; };
      if (plane && std::all_of(corners.begin(), corners.end(), isNear) &&
        AreAboveEachOther(others, corners, plane->Normal, this->Tolerance))
      {
        for (const Point& p : corners)
        {
          places[p].push_back(*plane);
        }
      }
    });
}

Id GapCloser::Move(const Places& places, Body& body) const
{
  std::map<Point, Point> moved;
  for (const auto& [place, planes] : places)
  {
    const Point there = MovedInto(planes, place);
    if (there != place && Distance(there, place) <= this->Tolerance &&
      this->Fixed.count(place) == 0)
    {
      moved[place] = there;
    }
  }
  for (Point& p : body.Soup.Points)
  {
    const auto there = IsFinite(p) ? moved.find(p) : moved.end();
    p = there == moved.end() ? p : there->second;
  }
  return static_cast<Id>(moved.size());
}

Id GapCloser::CloseAll()
{
  const LoopProgress progress(this->Watch, { Stages::Validating, 0, 0 }, this->Facets.size());
  Id moved = 0;
  auto facet = this->Facets.begin();
  for (std::size_t b = 0; b < this->Bodies.size(); ++b)
  {
    Places places;
    for (; facet != this->Facets.end() && facet->Body == static_cast<Id>(b); ++facet)
    {
      progress.Check(static_cast<std::size_t>(facet - this->Facets.begin()));
      this->FindPlanes(*facet, places);
    }
    moved += this->Move(places, this->Bodies[b]);
    for (const Point& p : this->Bodies[b].Soup.Points)
    {
      if (IsFinite(p))
      {
        this->Fixed.insert(p);
      }
    }
  }
  return moved;
}
} // namespace

Id CloseGaps(std::vector<Body>& bodies, double tolerance, Monitor& monitor)
{
  return GapCloser(bodies, tolerance, monitor).CloseAll();
}
} // namespace insideout
