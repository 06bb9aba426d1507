// SPDX-License-Identifier: GPL-3.0-or-later
#include "Resolve/WorkingSurface.h"

#include "Common/ParallelLoop.h"
#include "Common/PointPredicates.h"
#include "Common/SortUniquely.h"
#include "Common/SortedTriangle.h"
#include "Common/Stages.h"
#include "Common/Vectors.h"
#include "Resolve/AppendFacet.h"
#include "Resolve/FindIntersections.h"
#include "Resolve/Interpolation.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <string>
#include <unordered_map>

namespace insideout
{
namespace
{
Meaning MeaningOfGiven(const FacetComplex& surface, Id facet)
{
  const auto sources = surface.Sources.begin();
  return { facet, surface.Multiplicity[facet],
    { sources + surface.SourceOffsets[facet], sources + surface.SourceOffsets[facet + 1] } };
}

std::int16_t CheckedMultiplicity(const Meaning& meaning)
{
  if (std::abs(meaning.Multiplicity) > std::numeric_limits<std::int16_t>::max())
  {
    throw Error(ErrorCode::TooLarge,
      "triangle " + std::to_string(meaning.Sources[0].Triangle) + " lies in a face that counts " +
        std::to_string(meaning.Multiplicity) + " times; at most 32767 can be counted");
  }
  return static_cast<std::int16_t>(meaning.Multiplicity);
}

void Append(FacetComplex& surface, const Triangle& corners, const Meaning& meaning)
{
  surface.Facets.push_back(corners);
  surface.Multiplicity.push_back(CheckedMultiplicity(meaning));
  surface.Sources.insert(surface.Sources.end(), meaning.Sources.begin(), meaning.Sources.end());
  surface.SourceOffsets.push_back(static_cast<Id>(surface.Sources.size()));
}
} // namespace

void Add(Meaning& meaning, const Meaning& other, bool reversed)
{
  meaning.Multiplicity += reversed ? -other.Multiplicity : other.Multiplicity;
  for (const FacetSource& source : other.Sources)
  {
    const FacetSource added = { source.Triangle, source.Reversed != reversed };
    const auto place = std::lower_bound(meaning.Sources.begin(), meaning.Sources.end(), added,
      [](const FacetSource& a, const FacetSource& b) { return a.Triangle < b.Triangle; });
    if (place != meaning.Sources.end() && place->Triangle == added.Triangle &&
      place->Reversed != added.Reversed)
    {
      meaning.Sources.erase(place);
    }
    else
    {
      meaning.Sources.insert(place, added);
    }
  }
}

WorkingSurface::WorkingSurface(const FacetComplex& given)
  : Points(given.Points)
  , Facets(given.Facets.begin(), given.Facets.begin() + given.NumberOfConstraints)
  , Given(&given)
  , MeaningIds(given.NumberOfConstraints)
{
  std::iota(this->MeaningIds.begin(), this->MeaningIds.end(), 0);
}

Id WorkingSurface::RootOf(Id facet) const
{
  const Id meaning = this->MeaningIds[facet];
  const Id given = this->Given->NumberOfFacets();
  return meaning < given ? meaning : this->Meanings[meaning - given].Root;
}

Meaning WorkingSurface::MeaningOf(Id facet) const
{
  const Id meaning = this->MeaningIds[facet];
  const Id given = this->Given->NumberOfFacets();
  return meaning < given ? MeaningOfGiven(*this->Given, meaning) : this->Meanings[meaning - given];
}

Id WorkingSurface::AddMeaning(Meaning meaning)
{
  this->Meanings.push_back(std::move(meaning));
  return static_cast<Id>(this->Given->Facets.size() + this->Meanings.size() - 1);
}

Id WorkingSurface::AddPoint(const Point& p, Id root)
{
  this->Points.push_back(p);
  this->Roots.push_back(root);
  return static_cast<Id>(this->Points.size() - 1);
}

std::vector<Id> WorkingSurface::UncheckedFacets() const
{
  std::vector<Id> unchecked(this->Facets.size() - this->FirstUnchecked);
  std::iota(unchecked.begin(), unchecked.end(), this->FirstUnchecked);
  return unchecked;
}

/** The facets that rounding made degenerate: they come directly from a cut. */
std::vector<Id> WorkingSurface::DegenerateFacets() const
{
  std::vector<Id> degenerate;
  for (Id f = this->FirstUnchecked; f < static_cast<Id>(this->Facets.size()); ++f)
  {
    if (IsDegenerate(this->Points, this->Facets[f]))
    {
      degenerate.push_back(f);
    }
  }
  return degenerate;
}

std::vector<Id> WorkingSurface::CrossingFacets() const
{
  std::vector<Id> crossing;
  for (const auto& pair : this->Crossings)
  {
    crossing.insert(crossing.end(), pair.begin(), pair.end());
  }
  SortUniquely(crossing);
  return crossing;
}

void WorkingSurface::Apply(const Replacement& replacement)
{
  std::vector<char> isRemoved(this->Facets.size(), 0);
  for (const Id f : replacement.Removed)
  {
    isRemoved[f] = 1;
  }
  std::vector<MeantFacet> parts;
  for (const ReplacedFacet& part : replacement.Added)
  {
    parts.push_back({ part.Corners, this->MeaningOf(part.Parent) });
  }
  this->Replace(std::move(isRemoved), parts);
}

/** Remove facets, and append others after those that stay. */
void WorkingSurface::Replace(std::vector<char> isRemoved, const std::vector<MeantFacet>& added)
{
  this->AddFacets(added, isRemoved);
  std::vector<Id> kept(this->Facets.size(), None);
  Id count = 0;
  Id firstUnchecked = 0;
  for (std::size_t f = 0; f < this->Facets.size(); ++f)
  {
    if (isRemoved[f])
    {
      continue;
    }
    this->Facets[count] = this->Facets[f];
    this->MeaningIds[count] = this->MeaningIds[f];
    kept[f] = count++;
    firstUnchecked = static_cast<Id>(f) < this->FirstUnchecked ? count : firstUnchecked;
  }
  this->Facets.resize(count);
  this->MeaningIds.resize(count);
  this->FirstUnchecked = firstUnchecked;
  std::vector<std::array<Id, 2>> crossings;
  for (const auto& pair : this->Crossings)
  {
    if (kept[pair[0]] != None && kept[pair[1]] != None)
    {
      crossings.push_back({ kept[pair[0]], kept[pair[1]] });
    }
  }
  this->Crossings = std::move(crossings);
}

/** Find the crossings of the facets that are not searched yet. */
void WorkingSurface::FindCrossings(Monitor& monitor)
{
  const std::vector<std::array<Id, 2>> found =
    FindIntersections(this->Points, this->Facets, this->FirstUnchecked, monitor);
  this->Crossings.insert(this->Crossings.end(), found.begin(), found.end());
  std::sort(this->Crossings.begin(), this->Crossings.end());
  this->FirstUnchecked = static_cast<Id>(this->Facets.size());
}

void WorkingSurface::FindCrossingsBetween(
  const std::vector<Id>& setOf, const std::vector<std::array<Id, 2>>& known, Monitor& monitor)
{
  this->Crossings = FindIntersectionsBetween(this->Points, this->Facets, setOf, monitor);
  this->Crossings.insert(this->Crossings.end(), known.begin(), known.end());
  SortUniquely(this->Crossings);
  this->FirstUnchecked = static_cast<Id>(this->Facets.size());
}

/**
 * Add facets. One with the corners of an existing facet adds its meaning to that. Facets left
 * without a meaning are marked as removed.
 */
void WorkingSurface::AddFacets(const std::vector<MeantFacet>& facets, std::vector<char>& isRemoved)
{
  std::vector<char> touched(this->Points.size(), 0);
  for (const MeantFacet& facet : facets)
  {
    touched[facet.Corners[0]] = touched[facet.Corners[1]] = touched[facet.Corners[2]] = 1;
  }
  std::unordered_map<Triangle, Id, HashOfTriangle> known;
  for (Id f = 0; f < static_cast<Id>(this->Facets.size()); ++f)
  {
    const Triangle& corners = this->Facets[f];
    if (!isRemoved[f] && touched[corners[0]] && touched[corners[1]] && touched[corners[2]])
    {
      known.insert({ SortedTriangle(corners).Points, f });
    }
  }
  for (const MeantFacet& facet : facets)
  {
    const SortedTriangle sorted(facet.Corners);
    const Id next = static_cast<Id>(this->Facets.size());
    const auto inserted = known.insert({ sorted.Points, next });
    if (inserted.second)
    {
      this->Facets.push_back(facet.Corners);
      isRemoved.push_back(facet.Means.Sources.empty());
      this->MeaningIds.push_back(this->AddMeaning(facet.Means));
      continue;
    }
    const Id same = inserted.first->second;
    Meaning sum = this->MeaningOf(same);
    Add(sum, facet.Means, SortedTriangle(this->Facets[same]).Turned != sorted.Turned);
    isRemoved[same] = sum.Sources.empty();
    this->MeaningIds[same] = this->AddMeaning(std::move(sum));
  }
}

/** Drop new points that no facet uses any more. */
void WorkingSurface::DropUnusedPoints()
{
  const std::size_t given = this->Given->Points.size();
  std::vector<Id> places(this->Points.size(), None);
  for (const Triangle& t : this->Facets)
  {
    places[t[0]] = places[t[1]] = places[t[2]] = 0;
  }
  std::size_t count = given;
  for (std::size_t p = 0; p < places.size(); ++p)
  {
    if (p < given)
    {
      places[p] = static_cast<Id>(p);
    }
    else if (places[p] != None)
    {
      this->Points[count] = this->Points[p];
      this->Roots[count - given] = this->Roots[p - given];
      places[p] = static_cast<Id>(count++);
    }
  }
  this->Points.resize(count);
  for (Triangle& t : this->Facets)
  {
    t = { places[t[0]], places[t[1]], places[t[2]] };
  }
}

/** Append a facet to the assembled complex. Most are unchanged: nothing is copied for them. */
void WorkingSurface::AppendTo(FacetComplex& surface, Id facet) const
{
  const Id meaning = this->MeaningIds[facet];
  if (meaning < this->Given->NumberOfFacets())
  {
    AppendFacet(surface, this->Facets[facet], *this->Given, meaning);
  }
  else
  {
    Append(surface, this->Facets[facet], this->Meanings[meaning - this->Given->NumberOfFacets()]);
  }
}

/** The constraints, then the facets left out, then those that the given complex had left out. */
FacetComplex WorkingSurface::Assemble(const std::vector<Id>& leftOut, Monitor& monitor)
{
  this->DropUnusedPoints();
  FacetComplex surface;
  const std::size_t facets = this->Facets.size();
  surface.Facets.reserve(facets);
  surface.Multiplicity.reserve(facets);
  surface.SourceOffsets.reserve(facets + 1);
  surface.Sources.reserve(std::max(facets, this->Given->Sources.size()));
  auto next = leftOut.begin();
  for (Id f = 0; f < static_cast<Id>(this->Facets.size()); ++f)
  {
    if (next != leftOut.end() && *next == f)
    {
      ++next;
      continue;
    }
    this->AppendTo(surface, f);
  }
  surface.NumberOfConstraints = surface.NumberOfFacets();
  for (const Id f : leftOut)
  {
    this->AppendTo(surface, f);
  }
  for (Id f = this->Given->NumberOfConstraints; f < this->Given->NumberOfFacets(); ++f)
  {
    AppendFacet(surface, this->Given->Facets[f], *this->Given, f);
  }
  surface.Origins = this->OriginsOfPoints(monitor);
  surface.Points = std::move(this->Points);
  return surface;
}

/** The origins of points: given points keep theirs, new ones have that of the facet they lie on. */
std::vector<PointOrigin> WorkingSurface::OriginsOfPoints(Monitor& monitor) const
{
  const Id given = static_cast<Id>(this->Given->Origins.size());
  std::vector<PointOrigin> origins;
  origins.reserve(this->Points.size());
  origins = this->Given->Origins;
  origins.resize(this->Points.size());
  const double nanosecondsPerPoint = 1400;
  ParallelLoop(static_cast<Id>(this->Points.size()) - given, nanosecondsPerPoint, monitor,
    { Stages::Resolving, 1, 1 },
    [&](Id i)
    {
      const Triangle& corners = this->Given->Facets[this->Roots[i]];
      PointOrigin& origin = origins[given + i];
      for (int k = 0; k < 3; ++k)
      {
        origin.Points[k] = this->Given->Origins[corners[k]].Points[0];
      }
      origin.Weights =
        BarycentricWeights(CornersOf(this->Given->Points, corners), this->Points[given + i]);
    });
  return origins;
}
} // namespace insideout
