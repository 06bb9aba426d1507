// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/NearBodies.h"

#include "Common/ScaledPoints.h"
#include "Common/SortUniquely.h"
#include "Common/Stages.h"
#include "Common/Vectors.h"
#include "Resolve/CutLayers.h"
#include "Resolve/SnappingRadius.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace insideout
{
namespace
{
/** Limit of the pairs of bodies named in messages. */
constexpr std::size_t MostNamed = 10;

/** Other facets of the two bodies may be some more roundings apart than those found. */
constexpr double Margin = 16;

/** The layers that nearly coincide in two bodies. */
struct Contact
{
  std::vector<Id> Triangles;
  double Distance = 0;
};

using Contacts = std::map<std::array<Id, 2>, Contact>;

/** The largest distance of a triangle's corners from the plane of another. */
double LargestHeight(const std::array<Point, 3>& triangle, const std::array<Point, 3>& other)
{
  const Point normal = NormalOf(triangle[0], triangle[1], triangle[2]);
  double largest = 0;
  for (const Point& p : other)
  {
    largest = std::max(largest, std::abs(Dot(normal, Difference(p, triangle[0]))));
  }
  return largest / Length(normal);
}

double DistanceOf(const FacetComplex& surface, Id f, Id g)
{
  const std::array<Point, 3> first = CornersOf(surface.Points, surface.Facets[f]);
  const std::array<Point, 3> second = CornersOf(surface.Points, surface.Facets[g]);
  return std::min(LargestHeight(first, second), LargestHeight(second, first));
}

/**
 * Add two layers to the contact of their bodies. An interface is not a neighbor of its own bodies.
 */
void AddLayers(const ResolvedBodies& bodies, Id f, Id g, Contacts& contacts)
{
  const FacetComplex& surface = bodies.Surface;
  for (Id i = bodies.CountOffsets[f]; i < bodies.CountOffsets[f + 1]; ++i)
  {
    const Id first = bodies.BodyCounts[i].Body;
    for (Id j = bodies.CountOffsets[g]; j < bodies.CountOffsets[g + 1]; ++j)
    {
      const Id second = bodies.BodyCounts[j].Body;
      if (CountFor(bodies, g, first) != 0 || CountFor(bodies, f, second) != 0)
      {
        continue;
      }
      Contact& contact = contacts[{ std::min(first, second), std::max(first, second) }];
      contact.Distance = std::max(contact.Distance, DistanceOf(surface, f, g));
      for (const Id facet : { f, g })
      {
        for (Id s = surface.SourceOffsets[facet]; s < surface.SourceOffsets[facet + 1]; ++s)
        {
          contact.Triangles.push_back(surface.Sources[s].Triangle);
        }
      }
    }
  }
}

/** The smallest power of ten that is at least this distance. */
double PowerOfTenFrom(double distance)
{
  return std::pow(10, std::ceil(std::log10(distance)));
}
} // namespace

std::vector<NearBodies> FindNearBodies(
  const ResolvedBodies& bodies, const std::vector<Id>& candidates, Monitor& monitor)
{
  const FacetComplex& surface = bodies.Surface;
  const double size = LargestCoordinate(surface.Points);
  const double radius = SnappingRadius(size);
  std::vector<Id> counting; // constraints that count, and for each a body that it counts for
  std::vector<Id> bodyOf;
  for (const Id f : candidates)
  {
    if (f < surface.NumberOfConstraints && bodies.CountOffsets[f] < bodies.CountOffsets[f + 1])
    {
      counting.push_back(f);
      bodyOf.push_back(bodies.BodyCounts[bodies.CountOffsets[f]].Body);
    }
  }
  Contacts contacts;
  for (const auto& [f, g] : FindLayers({ surface.Points, surface.Facets }, counting, radius,
         monitor, { Stages::Resolving, 1, 1 }, bodyOf))
  {
    AddLayers(bodies, f, g, contacts);
  }
  const double spacing = std::ldexp(size, -53); // smaller distances may be rounding errors
  std::vector<NearBodies> near;
  for (auto& [pair, contact] : contacts)
  {
    SortUniquely(contact.Triangles);
    const double distance = std::max(contact.Distance, spacing);
    near.push_back({ pair[0], pair[1], static_cast<Id>(contact.Triangles.size()), distance,
      PowerOfTenFrom(Margin * distance) });
  }
  return near;
}

std::vector<std::string> WordsOf(
  const std::vector<NearBodies>& near, const std::vector<std::string>& names, double tolerance)
{
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < std::min(near.size(), MostNamed); ++i)
  {
    const NearBodies& pair = near[i];
    std::ostringstream line;
    line.precision(2);
    line << "bodies " << names[pair.First] << " and " << names[pair.Second]
         << " nearly touch: " << pair.Triangles << " triangles are within " << pair.Distance
         << " of the other's";
    if (tolerance < pair.Tolerance)
    {
      line << "; TouchTolerance " << pair.Tolerance << " makes them one interface";
    }
    lines.push_back(line.str());
  }
  if (near.size() > MostNamed)
  {
    lines.push_back(std::to_string(near.size() - MostNamed) + " more pairs of bodies nearly touch");
  }
  return lines;
}
} // namespace insideout
