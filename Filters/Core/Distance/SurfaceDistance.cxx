// SPDX-License-Identifier: GPL-3.0-or-later
#include "Distance/SurfaceDistance.h"

#include "Common/ChunkedLoop.h"
#include "Common/NearestPoint.h"
#include "Common/ScaledPoints.h"
#include "Common/Vectors.h"
#include "WindingNumber/SpatialOrder.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace insideout
{
namespace
{
// Boxes are passed over that are farther than the nearest facet so far by more than rounding, so
// that no facet is passed over which another order would find.
constexpr double RoundedUp = 1 + 0x1p-40;

std::vector<std::array<Point, 3>> ScaledCorners(
  const std::vector<Point>& points, const std::vector<Triangle>& facets, int exponent)
{
  const PowerOfTwo scale(exponent);
  std::vector<std::array<Point, 3>> scaled;
  scaled.reserve(facets.size());
  for (const Triangle& facet : facets)
  {
    scaled.push_back(CornersOf(points, facet));
    for (Point& corner : scaled.back())
    {
      corner = { scale.Times(corner[0]), scale.Times(corner[1]), scale.Times(corner[2]) };
    }
  }
  return scaled;
}

std::vector<Box> BoxesOf(const std::vector<std::array<Point, 3>>& facets)
{
  std::vector<Box> boxes;
  boxes.reserve(facets.size());
  for (const std::array<Point, 3>& corners : facets)
  {
    Box box = { corners[0], corners[0] };
    box.Add(corners[1]);
    box.Add(corners[2]);
    boxes.push_back(box);
  }
  return boxes;
}
} // namespace

SurfaceDistance::SurfaceDistance(
  const std::vector<Point>& points, const std::vector<Triangle>& facets)
  : SurfaceDistance(points, facets, LargestExponent(points))
{
}

SurfaceDistance::SurfaceDistance(
  const std::vector<Point>& points, const std::vector<Triangle>& facets, int exponent)
  : Exponent(exponent)
  , Facets(ScaledCorners(points, facets, -this->Exponent))
  , Tree(BoxesOf(this->Facets))
{
}

/** @param[in] hint a facet that is likely near, which saves time */
SurfaceDistance::Nearest SurfaceDistance::NearestTo(const Point& place, Id hint) const
{
  if (!IsFinite(place))
  {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    return { nan, { nan, nan, nan }, None, nan };
  }
  const PowerOfTwo down(-this->Exponent);
  const PowerOfTwo up(this->Exponent);
  const auto unscaled = [&](const Point& p) {
    return Point{ up.Times(p[0]), up.Times(p[1]), up.Times(p[2]) };
  };
  const Point scaled = { down.Times(place[0]), down.Times(place[1]), down.Times(place[2]) };
  if (!IsNear(scaled))
  {
    const Point there = unscaled(this->Facets[0][0]);
    return { Distance(place, there), there, 0, 0 }; // all parts are as near
  }
  const double infinity = std::numeric_limits<double>::infinity();
  Nearest best = { infinity, {}, None, infinity };
  const auto look = [&](Id facet)
  {
    const Point there = NearestPointOf(this->Facets[facet], scaled);
    const Point d = Difference(there, scaled);
    const Nearest found = { 0, there, facet, Dot(d, d) };
    if (found.IsNearerThan(best))
    {
      best = found;
    }
  };
  look(hint);
  this->Tree.VisitNearestFirst([&](const Box& box) { return SquaredDistance(box, scaled); },
    [&] { return best.Squared * RoundedUp; }, look);
  best.Distance = up.Times(Distance(best.Place, scaled));
  best.Place = unscaled(best.Place);
  return best;
}

SurfaceDistance::Nearest SurfaceDistance::At(const Point& place) const
{
  return this->NearestTo(place, 0);
}

std::vector<SurfaceDistance::Nearest> SurfaceDistance::At(
  const std::vector<Point>& places, Monitor& monitor, const ProgressRange& progress) const
{
  const std::vector<Id> order = SpatialOrderOfAny(places);
  std::vector<Nearest> nearest(places.size());
  const Id placesPerCall = 256;
  const Id size = static_cast<Id>(places.size());
  const double nanosecondsPerPlace = 1000;
  ChunkedLoop((size + placesPerCall - 1) / placesPerCall, nanosecondsPerPlace * placesPerCall,
    monitor, progress,
    [&](Id call)
    {
      Id hint = 0;
      for (Id i = call * placesPerCall; i < std::min(size, (call + 1) * placesPerCall); ++i)
      {
        const Nearest& found = nearest[order[i]] = this->NearestTo(places[order[i]], hint);
        hint = found.Facet != None ? found.Facet : hint;
      }
    });
  return nearest;
}
} // namespace insideout
