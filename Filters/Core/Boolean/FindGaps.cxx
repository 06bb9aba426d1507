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
/** Per point, whether it is near some facets. */
std::vector<char> ArePointsNear(const std::vector<Point>& points,
  const std::vector<Triangle>& facets, double tolerance, Monitor& monitor)
{
  Box box = Box::Empty();
  for (const Triangle& facet : facets)
  {
    box.Add(BoundingBox(points, facet));
  }
  box = box.Widened(tolerance);
  std::vector<Id> ids;
  std::vector<Point> places;
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    if (box.Holds(points[p]))
    {
      ids.push_back(static_cast<Id>(p));
      places.push_back(points[p]);
    }
  }
  const std::vector<SurfaceDistance::Nearest> nearest =
    SurfaceDistance(points, facets).At(places, monitor, { Stages::Resolving, 1, 1 });
  std::vector<char> areNear(points.size(), 0);
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
    std::vector<Triangle> own;
    std::vector<Triangle> others;
    for (Id f = 0; f < surface.NumberOfFacets(); ++f)
    {
      (CountFor(bodies, f, body) != 0 ? own : others).push_back(surface.Facets[f]);
    }
    if (own.empty() || others.empty())
    {
      continue;
    }
    const std::vector<char> areNear = ArePointsNear(surface.Points, own, tolerance, monitor);
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
