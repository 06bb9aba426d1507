// SPDX-License-Identifier: GPL-3.0-or-later
#include "Distance/SurfaceDistance.h"

#include "Common/ChunkedLoop.h"
#include "Common/NearestPoint.h"
#include "Common/ScaledPoints.h"
#include "Common/Vectors.h"
#include "Distance/NearFacets.h"
#include "WindingNumber/SpatialOrder.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace insideout
{
namespace
{
// Boxes are skipped if they are farther than the nearest facet so far by more than rounding, so
// that the result does not depend on the order. The nearest place on a facet is off by less than e
// = 2^-50 of the coordinates, by which a facet seems nearer than its box; with t = 2^-41, (d + e)^2
// is less than d^2 (1 + t) + 2 e^2 / t.
constexpr double RoundedUp = 1 + 0x1p-40;
constexpr double SquaredRounding = 0x1p-58;

// Number of places from which neighbors on a space-filling curve share a search: scattered ones
// share too little. For 2,000 places in the box of a model sharing takes 0.8 of the time, for 100
// it takes 1.6 times as long.
constexpr Id FewPlaces = 1024;
constexpr Id PlacesPerCall = 256;

/** The margin of a squared bound above the squared distance from a scaled place. */
double RoomAt(const Point& scaled)
{
  return SquaredRounding * (1 + Dot(scaled, scaled));
}

const SurfaceDistance::Nearest Nothing = { 0, {}, None, std::numeric_limits<double>::infinity() };

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

bool SurfaceDistance::Scale(const Point& place, Point& scaled) const
{
  const PowerOfTwo down(-this->Exponent);
  scaled = { down.Times(place[0]), down.Times(place[1]), down.Times(place[2]) };
  return IsFinite(place) && IsNear(scaled);
}

SurfaceDistance::Nearest SurfaceDistance::Unscaled(const Nearest& found, const Point& scaled) const
{
  const PowerOfTwo up(this->Exponent);
  const Point& there = found.Place;
  return { up.Times(Distance(there, scaled)),
    { up.Times(there[0]), up.Times(there[1]), up.Times(there[2]) }, found.Facet, found.Squared };
}

/** The result for a place that is not finite, or so far away that all facets are equally near. */
SurfaceDistance::Nearest SurfaceDistance::FromAfar(const Point& place) const
{
  if (!IsFinite(place))
  {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    return { nan, { nan, nan, nan }, None, nan };
  }
  const Point there = this->Unscaled({ 0, this->Facets[0][0], 0, 0 }, {}).Place;
  return { Distance(place, there), there, 0, 0 };
}

/** Check whether a facet is nearer to a scaled place than the nearest so far. */
void SurfaceDistance::Look(Id facet, const Point& scaled, Nearest& best) const
{
  const Point there = NearestPointOf(this->Facets[facet], scaled);
  const Point d = Difference(there, scaled);
  const Nearest found = { 0, there, facet, Dot(d, d) };
  if (found.IsNearerThan(best))
  {
    best = found;
  }
}

/** @param[in] hint a probably near facet, to save time */
SurfaceDistance::Nearest SurfaceDistance::NearestTo(const Point& place, Id hint) const
{
  Point scaled;
  if (!this->Scale(place, scaled))
  {
    return this->FromAfar(place);
  }
  const double room = RoomAt(scaled);
  Nearest best = Nothing;
  this->Look(hint, scaled, best);
  this->Tree.VisitNearestFirst([&](const Box& box) { return SquaredDistance(box, scaled); },
    [&] { return best.Squared * RoundedUp + room; },
    [&](Id facet) { this->Look(facet, scaled, best); });
  return this->Unscaled(best, scaled);
}

SurfaceDistance::Nearest SurfaceDistance::At(const Point& place) const
{
  return this->NearestTo(place, 0);
}

void SurfaceDistance::AtSome(const std::vector<Point>& places, const Id* first, const Id* last,
  std::vector<Nearest>& nearest) const
{
  Id hint = 0;
  for (; first != last; ++first)
  {
    const Nearest& found = nearest[*first] = this->NearestTo(places[*first], hint);
    hint = found.Facet != None ? found.Facet : hint;
  }
}

/** The same, several places at a time. */
void SurfaceDistance::AtMany(const std::vector<Point>& places, const Id* first, const Id* last,
  std::vector<Nearest>& nearest) const
{
  constexpr int lanes = PointBlock::Lanes;
  PointBlock block;
  Point scaled[lanes];
  Id ids[lanes];
  Nearest best[lanes];
  std::vector<NearFacet> facets;
  Id hint = this->NearestTo(places[*first], 0).Facet;
  hint = hint == None ? 0 : hint;
  while (first != last)
  {
    int used = 0;
    for (; first != last && used < lanes; ++first)
    {
      ids[used] = *first;
      if (this->Scale(places[*first], scaled[used]))
      {
        ++used;
      }
      else
      {
        nearest[*first] = this->FromAfar(places[*first]);
      }
    }
    for (int lane = 0; used > 0 && lane < lanes; ++lane)
    {
      scaled[lane] = scaled[std::min(lane, used - 1)]; // the last place fills the block
      best[lane] = Nothing;
      this->Look(hint, scaled[lane], best[lane]);
      block.Room[lane] = RoomAt(scaled[lane]);
      block.Bound[lane] = best[lane].Squared * RoundedUp + block.Room[lane];
      for (int axis = 0; axis < 3; ++axis)
      {
        block.Of[axis][lane] = scaled[lane][axis];
      }
    }
    if (used > 0)
    {
      FindNearFacets(this->Tree, this->Facets, block, facets);
    }
    for (int lane = 0; lane < used; ++lane)
    {
      for (const NearFacet& facet : facets)
      {
        const double bound = best[lane].Squared * RoundedUp + block.Room[lane];
        if (facet.Least[lane] <= std::min(block.Bound[lane], bound))
        {
          this->Look(facet.Facet, scaled[lane], best[lane]);
        }
      }
      hint = best[lane].Facet;
      nearest[ids[lane]] = this->Unscaled(best[lane], scaled[lane]);
    }
  }
}

std::vector<SurfaceDistance::Nearest> SurfaceDistance::At(
  const std::vector<Point>& places, Monitor& monitor, const ProgressRange& progress) const
{
  const std::vector<Id> order = SpatialOrderOfAny(places);
  std::vector<Nearest> nearest(places.size());
  const Id size = static_cast<Id>(places.size());
  const auto work = size < FewPlaces ? &SurfaceDistance::AtSome : &SurfaceDistance::AtMany;
  const double nanosecondsPerPlace = 1000;
  ChunkedLoop((size + PlacesPerCall - 1) / PlacesPerCall, nanosecondsPerPlace * PlacesPerCall,
    monitor, progress,
    [&](Id call)
    {
      const Id* const first = order.data() + static_cast<std::ptrdiff_t>(call) * PlacesPerCall;
      (this->*work)(places, first, std::min(first + PlacesPerCall, order.data() + size), nearest);
    });
  return nearest;
}
} // namespace insideout
