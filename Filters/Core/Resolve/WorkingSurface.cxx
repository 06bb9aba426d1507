// SPDX-License-Identifier: GPL-3.0-or-later
#include "Resolve/WorkingSurface.h"

#include "Common/ParallelLoop.h"
#include "Common/PointPredicates.h"
#include "Common/SortUniquely.h"
#include "Common/SortedTriangle.h"
#include "Common/Stages.h"
#include "Common/Vectors.h"
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

WorkingSurface::WorkingSurface(FacetComplex& given)
  : Points(std::move(given.Points))
  , Facets(given.Facets.begin(), given.Facets.begin() + given.NumberOfConstraints)
  , Given(&given)
  , GivenPoints(static_cast<Id>(this->Points.size()))
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
  const auto isGone = [&](Id f) { return isRemoved[f] != 0; };
  std::vector<Id> removed;
  for (Id f = 0; f < static_cast<Id>(isRemoved.size()); ++f)
  {
    if (isGone(f))
    {
      removed.push_back(f);
    }
  }
  std::size_t count = removed.empty() ? isRemoved.size() : static_cast<std::size_t>(removed[0]);
  for (std::size_t f = count; f < isRemoved.size(); ++f)
  {
    if (!isRemoved[f])
    {
      this->Facets[count] = this->Facets[f];
      this->MeaningIds[count] = this->MeaningIds[f];
      ++count;
    }
  }
  this->Facets.resize(count);
  this->MeaningIds.resize(count);
  const auto placeOf = [&](Id f) { return f - IndexIn(removed, f); }; // of one that stays
  this->FirstUnchecked = placeOf(this->FirstUnchecked);
  std::vector<std::array<Id, 2>> crossings;
  for (const auto& pair : this->Crossings)
  {
    if (!isGone(pair[0]) && !isGone(pair[1]))
    {
      crossings.push_back({ placeOf(pair[0]), placeOf(pair[1]) });
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

void WorkingSurface::FindCrossingsBetween(const std::vector<Id>& setOf,
  const std::vector<Id>& nearOthers, const std::vector<std::array<Id, 2>>& known, Monitor& monitor)
{
  this->Crossings =
    FindIntersectionsBetween(this->Points, this->Facets, setOf, nearOthers, monitor);
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
  const Id given = this->GivenPoints;
  std::vector<Id> places(this->Roots.size(), None); // of new points
  const auto forNewCorners = [&](const auto& visit)
  {
    for (Triangle& corners : this->Facets)
    {
      for (Id& p : corners)
      {
        if (p >= given)
        {
          visit(p);
        }
      }
    }
  };
  forNewCorners([&](Id p) { places[p - given] = 0; });
  Id count = 0;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (places[i] != None)
    {
      this->Points[given + count] = this->Points[given + i];
      this->Roots[count] = this->Roots[i];
      places[i] = given + count++;
    }
  }
  this->Points.resize(given + count);
  this->Roots.resize(count);
  forNewCorners([&](Id& p) { p = places[p - given]; });
}

/** Move facets behind all others, in their order. */
void WorkingSurface::MoveToEnd(const std::vector<Id>& leftOut)
{
  std::vector<char> isLeftOut(this->Facets.size(), 0);
  std::vector<Triangle> facets;
  std::vector<Id> meanings;
  for (const Id f : leftOut)
  {
    isLeftOut[f] = 1;
    facets.push_back(this->Facets[f]);
    meanings.push_back(this->MeaningIds[f]);
  }
  for (std::size_t f = 0, count = 0; !leftOut.empty() && f < isLeftOut.size(); ++f)
  {
    if (!isLeftOut[f])
    {
      this->Facets[count] = this->Facets[f];
      this->MeaningIds[count] = this->MeaningIds[f];
      ++count;
    }
  }
  std::copy(facets.rbegin(), facets.rend(), this->Facets.rbegin());
  std::copy(meanings.rbegin(), meanings.rend(), this->MeaningIds.rbegin());
}

/** Set the multiplicities and sources of facets. */
void WorkingSurface::SetMeanings(FacetComplex& surface) const
{
  const FacetComplex& given = *this->Given;
  const auto sourcesOf = [&](Id meaning) -> std::array<const FacetSource*, 2>
  {
    if (meaning < given.NumberOfFacets())
    {
      const FacetSource* const all = given.Sources.data();
      return { all + given.SourceOffsets[meaning], all + given.SourceOffsets[meaning + 1] };
    }
    const std::vector<FacetSource>& own = this->Meanings[meaning - given.NumberOfFacets()].Sources;
    return { own.data(), own.data() + own.size() };
  };
  surface.Multiplicity.reserve(surface.Facets.size());
  surface.SourceOffsets.reserve(surface.Facets.size() + 1);
  for (const Id meaning : this->MeaningIds)
  {
    const auto [first, last] = sourcesOf(meaning);
    surface.SourceOffsets.push_back(surface.SourceOffsets.back() + static_cast<Id>(last - first));
    surface.Multiplicity.push_back(meaning < given.NumberOfFacets()
        ? given.Multiplicity[meaning]
        : CheckedMultiplicity(this->Meanings[meaning - given.NumberOfFacets()]));
  }
  surface.Sources.resize(static_cast<std::size_t>(surface.SourceOffsets.back()));
  const double nanosecondsPerFacet = 5;
  ParallelLoop(this->MeaningIds.size(), nanosecondsPerFacet,
    [&](std::size_t f)
    {
      const auto [first, last] = sourcesOf(this->MeaningIds[f]);
      std::copy(first, last, surface.Sources.begin() + surface.SourceOffsets[f]);
    });
}

/** The constraints, then the facets left out, then those that the given complex had left out. */
FacetComplex WorkingSurface::Assemble(const std::vector<Id>& leftOut, Monitor& monitor)
{
  this->DropUnusedPoints();
  this->MoveToEnd(leftOut);
  FacetComplex surface;
  surface.NumberOfConstraints = static_cast<Id>(this->Facets.size() - leftOut.size());
  for (Id f = this->Given->NumberOfConstraints; f < this->Given->NumberOfFacets(); ++f)
  {
    this->Facets.push_back(this->Given->Facets[f]);
    this->MeaningIds.push_back(f);
  }
  surface.Facets = std::move(this->Facets);
  this->SetMeanings(surface);
  surface.Origins = this->OriginsOfPoints(monitor);
  surface.Points = std::move(this->Points);
  return surface;
}

/** The origins of points: given points keep theirs, new ones have that of the facet they lie on. */
std::vector<PointOrigin> WorkingSurface::OriginsOfPoints(Monitor& monitor) const
{
  const Id given = this->GivenPoints;
  std::vector<PointOrigin> origins = std::move(this->Given->Origins);
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
        origin.Points[k] = origins[corners[k]].Points[0];
      }
      origin.Weights =
        BarycentricWeights(CornersOf(this->Points, corners), this->Points[given + i]);
    });
  return origins;
}
} // namespace insideout
