// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/FindGaps.h"

#include "Common/Box.h"
#include "Common/Stages.h"
#include "Distance/SurfaceDistance.h"

#include <algorithm>

namespace insideout
{
namespace
{
/** Per point of the surface whether it is near a body's facets. */
std::vector<char> ArePointsNear(
  const FacetComplex& surface, const FacetComplex& body, double tolerance, Monitor& monitor)
{
  Box box = Box::Empty();
  for (const Triangle& facet : body.Facets)
  {
    box.Add(BoundingBox(body.Points, facet));
  }
  box = box.Widened(tolerance);
  std::vector<Id> ids;
  std::vector<Point> places;
  for (std::size_t p = 0; p < surface.Points.size(); ++p)
  {
    if (box.Holds(surface.Points[p]))
    {
      ids.push_back(static_cast<Id>(p));
      places.push_back(surface.Points[p]);
    }
  }
  const std::vector<SurfaceDistance::Nearest> nearest =
    SurfaceDistance(body).At(places, monitor, { Stages::Resolving, 1, 1 });
  std::vector<char> areNear(surface.Points.size(), 0);
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    areNear[ids[i]] = nearest[i].Distance <= tolerance;
  }
  return areNear;
}
} // namespace

bool MayHaveGaps(const ResolvedBodies& bodies, double tolerance, Monitor& monitor)
{
  const FacetComplex& surface = bodies.Surface;
  for (Id body = 0; body < bodies.NumberOfBodies(); ++body)
  {
    FacetComplex own;
    std::vector<Triangle> others;
    for (Id f = 0; f < surface.NumberOfFacets(); ++f)
    {
      (CountFor(bodies, f, body) != 0 ? own.Facets : others).push_back(surface.Facets[f]);
    }
    if (own.Facets.empty() || others.empty())
    {
      continue;
    }
    own.Points = surface.Points;
    const std::vector<char> areNear = ArePointsNear(surface, own, tolerance, monitor);
    if (std::any_of(others.begin(), others.end(),
          [&](const Triangle& facet)
          { return areNear[facet[0]] && areNear[facet[1]] && areNear[facet[2]]; }))
    {
      return true;
    }
  }
  return false;
}
} // namespace insideout
