// SPDX-License-Identifier: GPL-3.0-or-later
#include "Orient/Membranes.h"

#include "Common/FacetComplex.h"
#include "Common/Vectors.h"
#include "Orient/RandomNumbers.h"
#include "WindingNumber/SurfaceWindingNumber.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
namespace
{
/** Places on a shell and on its caps, fewer where there are many shells. */
constexpr Id LeastPlaces = 8;
constexpr Id MostPlaces = 256;
constexpr Id PlacesOfAll = 1 << 12;

/** Distance from a place, in units of the surface's size, at which the solid is looked for on both
 * sides: a sheet on the solid's surface is in it. */
constexpr double Beside = 0x1p-24;

/** The largest share of its area that a shell within the solid may have outside. */
constexpr double OutsideByChance = 0.2;

/** The least of half a sphere, on which it is 1/4 to 0.35; on a flat sheet it is 0. */
constexpr double LeastWinding = 0.25;

constexpr int MostRounds = 8;

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
    , Roles(chains.size(), ShellRole::Counts)
  {
  }

  std::vector<ShellRole> Find(Monitor& monitor)
  {
    std::vector<Id> candidates;
    Id solids = 0;
    for (Id shell = 0; shell < static_cast<Id>(this->Chains.size()); ++shell)
    {
      const bool bounds = this->Bounds(shell);
      if (!bounds && (this->Chains[shell].Kind == ShellKind::Sheet || this->Chains[shell].IsLoose))
      {
        candidates.push_back(shell);
      }
      solids += bounds;
    }
    if (!candidates.empty() && solids > 0)
    {
      const Id count = static_cast<Id>(candidates.size());
      const Id places = std::clamp(PlacesOfAll / count, LeastPlaces, MostPlaces);
      std::vector<Sheet> outside;
      for (const Id shell : candidates)
      {
        this->Judge(shell, places, outside);
      }
      this->KeepThoseThatBoundTogether(std::move(outside), monitor);
    }
    return std::move(this->Roles);
  }

private:
  /** A sheet that seals off nothing by itself, and where it is outside the solid. */
  struct Sheet
  {
    Id Shell;
    std::vector<Point> Outside;
  };

  bool Bounds(Id shell) const
  {
    return this->Chains[shell].Kind == ShellKind::Closed && !this->Chains[shell].IsLoose;
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

  std::vector<Point> OutsideOf(const Places& places, RandomNumbers& random) const
  {
    std::vector<Point> outside;
    for (const Place& place : places.All)
    {
      if (!this->IsInSolid(place, random))
      {
        outside.push_back(place.At);
      }
    }
    return outside;
  }

  void Judge(Id shell, Id count, std::vector<Sheet>& outside)
  {
    RandomNumbers random(static_cast<std::uint64_t>(shell));
    const ShellChain& chain = this->Chains[shell];
    const Places facets = PlacesOn(this->Points, chain.Facets, count, random);
    Sheet sheet = { shell, this->OutsideOf(facets, random) };
    const double places = static_cast<double>(count);
    const double shareOutside = static_cast<double>(sheet.Outside.size()) / places;
    if (shareOutside == 1 && !chain.IsLoose)
    {
      return; // a sheet beside the solid adds to w as all sheets do
    }
    this->Roles[shell] = ShellRole::Membrane;
    if (shareOutside > OutsideByChance)
    {
      const Places caps = PlacesOn(this->Points, chain.Caps, count, random);
      const double capsOutside =
        caps.Area * static_cast<double>(this->OutsideOf(caps, random).size()) / places;
      if (capsOutside <= LargestCaps * shareOutside * facets.Area)
      {
        this->Roles[shell] = ShellRole::Counts;
      }
      else if (shareOutside > 0.5)
      {
        outside.push_back(std::move(sheet));
      }
    }
  }

  /** The winding number of sheets, and of shells with holes, not capped. */
  SurfaceWindingNumber WindingNumberOf(const std::vector<Sheet>& sheets, Monitor& monitor) const
  {
    FacetComplex surface;
    std::vector<Id> index(this->Points.size(), None);
    std::vector<Id> shells;
    for (const Sheet& sheet : sheets)
    {
      shells.push_back(sheet.Shell);
    }
    for (Id shell = 0; shell < static_cast<Id>(this->Chains.size()); ++shell)
    {
      if (this->Chains[shell].Kind == ShellKind::Holed && !this->Chains[shell].IsLoose)
      {
        shells.push_back(shell);
      }
    }
    for (const Id shell : shells)
    {
      for (const CountedTriangle& triangle : this->Chains[shell].Facets)
      {
        Triangle facet = triangle.Corners;
        for (Id& p : facet)
        {
          if (index[p] == None)
          {
            index[p] = static_cast<Id>(surface.Points.size());
            surface.Points.push_back(this->Points[p]);
          }
          p = index[p];
        }
        surface.Facets.push_back(facet);
        const int count = this->Turned[shell] ? -triangle.Count : triangle.Count;
        surface.Multiplicity.push_back(static_cast<std::int16_t>(count));
      }
    }
    surface.NumberOfConstraints = surface.NumberOfFacets();
    return { surface, {}, monitor };
  }

  void KeepThoseThatBoundTogether(std::vector<Sheet> sheets, Monitor& monitor)
  {
    std::size_t before = 0;
    for (int round = 0; round < MostRounds && !sheets.empty() && sheets.size() != before; ++round)
    {
      before = sheets.size();
      const SurfaceWindingNumber w = this->WindingNumberOf(sheets, monitor);
      const auto boundsNothing = [&](const Sheet& sheet)
      {
        double sum = 0;
        for (const Point& p : sheet.Outside)
        {
          sum += w.At(p);
        }
        return std::abs(sum) < LeastWinding * static_cast<double>(sheet.Outside.size());
      };
      sheets.erase(std::remove_if(sheets.begin(), sheets.end(), boundsNothing), sheets.end());
    }
    for (const Sheet& sheet : sheets)
    {
      this->Roles[sheet.Shell] = ShellRole::Counts;
    }
  }

  const std::vector<Point>& Points;
  const std::vector<ShellChain>& Chains;
  const std::vector<char>& Turned;
  const RegionSampler& Sampler;
  std::vector<ShellRole> Roles;
};
} // namespace

std::vector<ShellRole> FindMembranes(const std::vector<Point>& points,
  const std::vector<ShellChain>& chains, const std::vector<char>& turned,
  const RegionSampler& sampler, Monitor& monitor)
{
  return MembraneFinder(points, chains, turned, sampler).Find(monitor);
}
} // namespace insideout
