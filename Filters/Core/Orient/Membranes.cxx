// SPDX-License-Identifier: GPL-3.0-or-later
#include "Orient/Membranes.h"

#include "Common/Box.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
namespace
{
/** Places on a shell and on its caps, fewer where there are many shells. */
constexpr Id LeastPlaces = 8;
constexpr Id MostPlaces = 128;
constexpr Id PlacesOfAll = 1 << 10;

/** Distance from a place, in units of the surface's size, at which the solid is looked for on both
 * sides: a sheet on the solid's surface is in it. */
constexpr double Beside = 0x1p-24;

/** The largest share of its area that a shell within the solid may have outside. */
constexpr double OutsideByChance = 0.2;

/** A shell that has a larger share of its area outside counts. */
constexpr double MostOutside = 0.5;

struct Place
{
  Point At;
  Point Normal; ///< of length 1, or 0 where doubles do not tell
};

struct Places
{
  std::vector<Place> All;
  double Area = 0;
};

Places PlacesOn(const std::vector<Point>& points, const std::vector<CountedTriangle>& triangles,
  Id count, RandomNumbers& random)
{
  Places places;
  std::vector<double> areaUpTo;
  for (const CountedTriangle& triangle : triangles)
  {
    const std::array<Point, 3> t = CornersOf(points, triangle.Corners);
    places.Area += Length(NormalOf(t[0], t[1], t[2])) / 2;
    areaUpTo.push_back(places.Area);
  }
  for (Id i = 0; i < count && !triangles.empty(); ++i)
  {
    const double area = places.Area * (static_cast<double>(i) + random.Next()) / count;
    const auto found = std::lower_bound(areaUpTo.begin(), areaUpTo.end() - 1, area);
    const auto& [a, b, c] = CornersOf(points, triangles[found - areaUpTo.begin()].Corners);
    const double root = std::sqrt(random.Next());
    const double share = random.Next();
    const Point normal = NormalOf(a, b, c);
    const double length = Length(normal);
    Place place;
    for (int axis = 0; axis < 3; ++axis)
    {
      place.At[axis] = (1 - root) * a[axis] + root * ((1 - share) * b[axis] + share * c[axis]);
      place.Normal[axis] = length > 0 ? normal[axis] / length : 0;
    }
    places.All.push_back(place);
  }
  return places;
}

class MembraneFinder
{
public:
  MembraneFinder(const std::vector<Point>& points, const std::vector<ShellChain>& chains,
    const std::vector<char>& turned, const RegionSampler& sampler)
    : Points(points)
    , Chains(chains)
    , Turned(turned)
    , Sampler(sampler)
  {
  }

  std::vector<ShellRole> Find()
  {
    std::vector<ShellRole> roles(this->Chains.size(), ShellRole::Counts);
    std::vector<Id> candidates;
    for (Id shell = 0; shell < static_cast<Id>(this->Chains.size()); ++shell)
    {
      if (this->Chains[shell].Kind == ShellKind::Sheet || this->Chains[shell].IsLoose)
      {
        candidates.push_back(shell);
      }
    }
    if (candidates.empty() || !this->FindSolid())
    {
      return roles;
    }
    const Id count = static_cast<Id>(candidates.size());
    const Id places = std::clamp(PlacesOfAll / count, LeastPlaces, MostPlaces);
    for (const Id shell : candidates)
    {
      if (this->IsMembrane(shell, places))
      {
        roles[shell] = ShellRole::Membrane;
      }
    }
    return roles;
  }

private:
  bool Bounds(Id shell) const
  {
    return this->Chains[shell].Kind == ShellKind::Closed && !this->Chains[shell].IsLoose;
  }

  /** Find the box around the solid. @return false where no shell is closed */
  bool FindSolid()
  {
    bool isThere = false;
    for (Id shell = 0; shell < static_cast<Id>(this->Chains.size()); ++shell)
    {
      if (this->Bounds(shell))
      {
        isThere = true;
        for (const CountedTriangle& triangle : this->Chains[shell].Triangles)
        {
          for (const Id p : triangle.Corners)
          {
            this->Solid.Add(this->Points[p]);
          }
        }
      }
    }
    return isThere;
  }

  bool IsInSolid(const Place& place, RandomNumbers& random) const
  {
    for (const double side : { -Beside, Beside })
    {
      Point beside;
      for (int axis = 0; axis < 3; ++axis)
      {
        beside[axis] = place.At[axis] + side * place.Normal[axis];
      }
      if (!this->Solid.Holds(beside))
      {
        continue;
      }
      int w = 0;
      for (const ShellWinding& winding : this->Sampler.At(beside, random))
      {
        const int turn = this->Turned[winding.Shell] ? -1 : 1;
        w += this->Bounds(winding.Shell) ? turn * winding.W : 0;
      }
      if (w > 0)
      {
        return true;
      }
    }
    return false;
  }

  /** The area outside the solid, and its share of all. */
  struct Outside
  {
    double Area;
    double Share;
  };

  Outside FindOutside(
    const std::vector<CountedTriangle>& triangles, Id count, RandomNumbers& random) const
  {
    const Places places = PlacesOn(this->Points, triangles, count, random);
    const auto outside = std::count_if(places.All.begin(), places.All.end(),
      [&](const Place& place) { return !this->IsInSolid(place, random); });
    const double share = static_cast<double>(outside) / static_cast<double>(count);
    return { share * places.Area, share };
  }

  bool IsMembrane(Id shell, Id places) const
  {
    RandomNumbers random(static_cast<std::uint64_t>(shell));
    const ShellChain& chain = this->Chains[shell];
    const Outside facets = this->FindOutside(chain.Facets, places, random);
    if (facets.Share <= OutsideByChance)
    {
      return true;
    }
    return facets.Share <= MostOutside &&
      this->FindOutside(chain.Caps, places, random).Area > LargestCaps * facets.Area;
  }

  const std::vector<Point>& Points;
  const std::vector<ShellChain>& Chains;
  const std::vector<char>& Turned;
  const RegionSampler& Sampler;
  Box Solid = Box::Empty(); ///< around all closed shells
};
} // namespace

std::vector<ShellRole> FindMembranes(const std::vector<Point>& points,
  const std::vector<ShellChain>& chains, const std::vector<char>& turned,
  const RegionSampler& sampler)
{
  return MembraneFinder(points, chains, turned, sampler).Find();
}
} // namespace insideout
