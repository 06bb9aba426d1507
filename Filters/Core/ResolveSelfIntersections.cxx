// SPDX-License-Identifier: GPL-3.0-or-later
#include "ResolveSelfIntersections.h"

#include "CollapseSlivers.h"
#include "CutFacets.h"
#include "CutLayers.h"
#include "FindIntersections.h"
#include "Interpolation.h"
#include "ParallelLoop.h"
#include "PointIndex.h"
#include "SortedTriangle.h"
#include "SplitAlike.h"
#include "TrianglePredicates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <unordered_map>

namespace insideout
{
namespace
{
constexpr const char* Stage = "resolving self-intersections";

/** Rounds after which what still crosses is left out. Most real models take one to three. */
constexpr int MaximumRounds = 10;

/** Rounds without fewer crossings than ever before, after which no more are tried. */
constexpr int Patience = 6;

/** Where crossings become this many times more than they once were, cutting makes things worse:
 * facets in nearly one plane, that cross along ever more lines. */
constexpr std::size_t Divergence = 4;

/**
 * How near two points, a point and an edge, or layers are at most taken for one: some spacings of
 * the doubles, because what lies nearer makes slivers that cross again. Three times that in each
 * round stays below 1e-12 of the largest coordinate.
 */
double SnappingRadius(double largestCoordinate)
{
  return std::ldexp(largestCoordinate, -45);
}

using Pairs = std::vector<std::array<Id, 2>>;

/** What a facet stands for, beside its corners. */
struct Meaning
{
  Id Root = None;                   ///< a facet of the given complex that it is a piece of
  int Multiplicity = 0;             ///< along its own orientation
  std::vector<FacetSource> Sources; ///< by triangle; one triangle's are all turned alike
};

Meaning MeaningOfGiven(const FacetComplex& surface, Id facet)
{
  const auto sources = surface.Sources.begin();
  return { facet, surface.Multiplicity[facet],
    { sources + surface.SourceOffsets[facet], sources + surface.SourceOffsets[facet + 1] } };
}

/**
 * Adds the sources and multiplicity of a coinciding facet, or of the reverse of one. Where rounding
 * folded a triangle onto itself, its piece and the reverse of that cancel.
 */
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

double LargestCoordinate(const std::vector<Point>& points)
{
  double largest = 0;
  for (const Point& p : points)
  {
    largest = std::max({ largest, std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
  }
  return largest;
}

/**
 * Facets to leave out so that none of the pairs is left whole: again and again the one in most
 * pairs, of several the last.
 */
std::vector<Id> CoverOf(Pairs pairs)
{
  std::vector<Id> cover;
  while (!pairs.empty())
  {
    std::map<Id, int> counts;
    for (const auto& pair : pairs)
    {
      ++counts[pair[0]];
      ++counts[pair[1]];
    }
    const Id worst = std::max_element(counts.begin(), counts.end(),
      [](const auto& a, const auto& b) {
        return a.second <= b.second;
      })->first;
    cover.push_back(worst);
    const auto isCovered = [&](const std::array<Id, 2>& pair)
    { return pair[0] == worst || pair[1] == worst; };
    pairs.erase(std::remove_if(pairs.begin(), pairs.end(), isCovered), pairs.end());
  }
  std::sort(cover.begin(), cover.end());
  return cover;
}

/** A facet on the way to the next round. */
struct CutFacet
{
  Triangle Corners;
  Meaning Means;
};

/** The surface between two rounds. */
struct State
{
  std::vector<Point> Points;
  std::vector<Triangle> Facets;
  std::vector<Id> MeaningIds; ///< one per facet: a given facet, or beyond those a piece's meaning
  Id FirstUnchecked = 0;      ///< facets from here on were not searched for crossings
  Pairs Crossings;            ///< pairs of facets that cross
};

class Resolver
{
public:
  Resolver(const FacetComplex& surface, Monitor& monitor);
  Resolution Resolve();

private:
  void CutRepeatedly();
  void Cut(const ProgressRange& progress);
  void MergeLayers();
  std::vector<std::vector<Id>> TakePieces(
    const std::vector<PlanarSubdivision>& subdivisions, double radius);
  void PrepareSnapping(const std::vector<char>& isCut, double radius);
  std::vector<std::vector<Id>> PlacePoints(const std::vector<PlanarSubdivision>& subdivisions);
  Id PlacePoint(const Point& p, Id root);
  std::vector<Id> DegenerateFacets() const;
  std::vector<Id> CrossingFacets() const;
  void MergePoints(const std::vector<Id>& candidates);
  void Collapse(const std::vector<Id>& candidates);
  void Apply(const Replacement& replacement);
  void FindCrossings();
  void Replace(std::vector<char> isRemoved, std::vector<CutFacet> added);
  std::vector<CutFacet> PlacedPieces(const std::vector<PlanarSubdivision>& subdivisions,
    const std::vector<std::vector<Id>>& ids) const;
  void AddFacets(std::vector<CutFacet> facets, std::vector<char>& isRemoved);
  Id AddMeaning(Meaning meaning);
  Id RootOf(Id meaning) const;
  Meaning MeaningOf(Id meaning) const;
  void DropUnusedPoints();
  FacetComplex Assemble(const std::vector<Id>& leftOut);
  std::vector<PointOrigin> OriginsOf(const std::vector<Point>& points) const;

  const FacetComplex& Surface;
  Monitor& Watch;
  const double Size; ///< the largest coordinate
  int Round = 0;

  State Now;
  std::vector<Meaning> Meanings; ///< of pieces, of all rounds
  std::vector<Id> Roots;         ///< of new points: the given facet that they lie on

  PointIndex Positions{ 0 }; ///< of all points
  PointIndex Nearby{ 0 };    ///< the points that new ones of this round may snap to
  PointIndex Moved{ 0 };     ///< by where they were: the points that were snapped in this round
};

Resolver::Resolver(const FacetComplex& surface, Monitor& monitor)
  : Surface(surface)
  , Watch(monitor)
  , Size(LargestCoordinate(surface.Points))
{
  this->Now.Points = surface.Points;
  this->Now.Facets.assign(
    surface.Facets.begin(), surface.Facets.begin() + surface.NumberOfConstraints);
  this->Now.MeaningIds.resize(surface.NumberOfConstraints);
  std::iota(this->Now.MeaningIds.begin(), this->Now.MeaningIds.end(), 0);
}

Resolution Resolver::Resolve()
{
  this->FindCrossings();
  Resolution resolution;
  resolution.IntersectingPairs = this->Now.Crossings;
  if (!this->Now.Crossings.empty())
  {
    for (Id p = 0; p < static_cast<Id>(this->Now.Points.size()); ++p)
    {
      this->Positions.Add(this->Now.Points[p], p);
    }
    this->CutRepeatedly();
  }
  resolution.Rounds = this->Round;
  resolution.Surface = this->Assemble(CoverOf(this->Now.Crossings));
  this->Watch.Check(Stage, 1);
  return resolution;
}

/** Cuts until nothing crosses, or else goes back to where the fewest facets crossed. */
void Resolver::CutRepeatedly()
{
  State best;
  int bestRound = 0;
  while (!this->Now.Crossings.empty() && this->Round < MaximumRounds)
  {
    ++this->Round;
    // How many rounds there will be is unknown: each takes half of the progress that is left.
    const double begin = 1 - std::ldexp(1.0, 1 - this->Round);
    const double end = 1 - std::ldexp(1.0, -this->Round);
    this->MergeLayers();
    this->Cut({ Stage, begin, end });
    this->Collapse(this->DegenerateFacets());
    this->FindCrossings();
    this->MergePoints(this->CrossingFacets());
    this->FindCrossings();
    this->Collapse(this->CrossingFacets());
    this->FindCrossings();
    const std::size_t count = this->Now.Crossings.size();
    if (count == 0)
    {
      return;
    }
    if (bestRound == 0 || count < best.Crossings.size())
    {
      best = this->Now;
      bestRound = this->Round;
    }
    if (count > Divergence * best.Crossings.size() || this->Round - bestRound == Patience)
    {
      break;
    }
  }
  this->Now = std::move(best);
}

/** Makes layers, which cross in nearly one plane, one. */
void Resolver::MergeLayers()
{
  const double radius = SnappingRadius(this->Size);
  const std::vector<PlanarSubdivision> subdivisions =
    CutLayers({ this->Now.Points, this->Now.Facets }, this->Now.Crossings, radius, this->Watch,
      { Stage, 0, 0 });
  if (!subdivisions.empty())
  {
    const std::vector<std::vector<Id>> ids = this->TakePieces(subdivisions, radius);
    std::vector<EdgeChain> chains;
    for (std::size_t s = 0; s < subdivisions.size(); ++s)
    {
      const std::vector<EdgeChain> more = ChainsOf(subdivisions[s], ids[s]);
      chains.insert(chains.end(), more.begin(), more.end());
    }
    this->Apply(SplitAlike(this->Now.Points, this->Now.Facets, chains));
    this->Collapse(this->DegenerateFacets());
    this->FindCrossings();
  }
}

/** Cuts the facets that cross. */
void Resolver::Cut(const ProgressRange& progress)
{
  this->Watch.Check(Stage, progress.Begin);
  const std::vector<PlanarSubdivision> subdivisions =
    CutFacets({ this->Now.Points, this->Now.Facets }, this->Now.Crossings, this->Watch, progress);
  this->TakePieces(subdivisions, this->Round == 1 ? 0 : SnappingRadius(this->Size));
  this->Watch.Check(Stage, progress.End);
}

/**
 * Puts pieces in the places of the facets that are subdivided. New points within the radius of a
 * facet's corner, or of one another, become one.
 * @return the ids of the points, by subdivision
 */
std::vector<std::vector<Id>> Resolver::TakePieces(
  const std::vector<PlanarSubdivision>& subdivisions, double radius)
{
  std::vector<char> isCut(this->Now.Facets.size(), 0);
  for (const PlanarSubdivision& subdivision : subdivisions)
  {
    for (const SubdividedFacet& facet : subdivision.Facets)
    {
      isCut[facet.Facet] = 1;
    }
  }
  this->PrepareSnapping(isCut, radius);
  std::vector<std::vector<Id>> ids = this->PlacePoints(subdivisions);
  this->Replace(std::move(isCut), this->PlacedPieces(subdivisions, ids));
  return ids;
}

void Resolver::PrepareSnapping(const std::vector<char>& isCut, double radius)
{
  this->Moved = PointIndex(0);
  this->Nearby = PointIndex(radius);
  std::vector<char> added(this->Now.Points.size(), 0);
  for (Id f = 0; f < static_cast<Id>(this->Now.Facets.size()); ++f)
  {
    for (const Id p : this->Now.Facets[f])
    {
      if (isCut[f] && !added[p])
      {
        this->Nearby.Add(this->Now.Points[p], p);
        added[p] = 1;
      }
    }
  }
}

/**
 * Gives every point of the subdivisions a place: each name is rounded once.
 * @return the ids of the points, by subdivision
 */
std::vector<std::vector<Id>> Resolver::PlacePoints(
  const std::vector<PlanarSubdivision>& subdivisions)
{
  std::vector<ConstructedPoint> names;
  for (const PlanarSubdivision& subdivision : subdivisions)
  {
    names.insert(names.end(), subdivision.Points.begin(), subdivision.Points.end());
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());

  std::vector<Point> rounded(names.size());
  const FacetList facets{ this->Now.Points, this->Now.Facets };
  ParallelLoop(static_cast<Id>(names.size()), this->Watch, { Stage, 0, 0 },
    [&](Id i) { rounded[i] = Nearest(names[i], facets); });

  std::vector<Id> placed(names.size(), None);
  std::vector<std::vector<Id>> ids;
  for (const PlanarSubdivision& subdivision : subdivisions)
  {
    ids.emplace_back(subdivision.Points.size(), None);
    for (const Piece& piece : subdivision.Pieces)
    {
      const Id root = this->RootOf(this->Now.MeaningIds[piece.Sources[0].Facet]);
      for (const Id p : piece.Corners)
      {
        if (ids.back()[p] != None)
        {
          continue;
        }
        const auto at =
          std::lower_bound(names.begin(), names.end(), subdivision.Points[p]) - names.begin();
        if (placed[at] == None)
        {
          placed[at] = this->PlacePoint(rounded[at], root);
        }
        ids.back()[p] = placed[at];
      }
    }
  }
  return ids;
}

/** The id of the point at p: one that stands there, or in later rounds near there, or a new one. */
Id Resolver::PlacePoint(const Point& p, Id root)
{
  const Id known = this->Positions.Find(p);
  if (known != None)
  {
    return known;
  }
  const Id moved = this->Moved.Find(p);
  if (moved != None)
  {
    return moved;
  }
  const Id near = this->Nearby.Find(p);
  if (near != None)
  {
    this->Moved.Add(p, near);
    return near;
  }
  const Id id = static_cast<Id>(this->Now.Points.size());
  this->Now.Points.push_back(p);
  this->Roots.push_back(root);
  this->Positions.Add(p, id);
  this->Nearby.Add(p, id);
  return id;
}

/** The pieces with their points placed; those that have one twice are nothing. */
std::vector<CutFacet> Resolver::PlacedPieces(
  const std::vector<PlanarSubdivision>& subdivisions, const std::vector<std::vector<Id>>& ids) const
{
  std::vector<CutFacet> facets;
  for (std::size_t s = 0; s < subdivisions.size(); ++s)
  {
    for (const Piece& piece : subdivisions[s].Pieces)
    {
      CutFacet facet;
      for (int k = 0; k < 3; ++k)
      {
        facet.Corners[k] = ids[s][piece.Corners[k]];
      }
      if (facet.Corners[0] == facet.Corners[1] || facet.Corners[1] == facet.Corners[2] ||
        facet.Corners[2] == facet.Corners[0])
      {
        continue;
      }
      facet.Means.Root = this->RootOf(this->Now.MeaningIds[piece.Sources[0].Facet]);
      for (const PieceSource& source : piece.Sources)
      {
        Add(facet.Means, this->MeaningOf(this->Now.MeaningIds[source.Facet]), source.Reversed);
      }
      facets.push_back(std::move(facet));
    }
  }
  return facets;
}

/** The facets that rounding made degenerate: they come right out of a cut. */
std::vector<Id> Resolver::DegenerateFacets() const
{
  std::vector<Id> degenerate;
  for (Id f = this->Now.FirstUnchecked; f < static_cast<Id>(this->Now.Facets.size()); ++f)
  {
    const Triangle& t = this->Now.Facets[f];
    if (IsDegenerate(this->Now.Points[t[0]], this->Now.Points[t[1]], this->Now.Points[t[2]]))
    {
      degenerate.push_back(f);
    }
  }
  return degenerate;
}

std::vector<Id> Resolver::CrossingFacets() const
{
  std::vector<Id> crossing;
  for (const auto& pair : this->Now.Crossings)
  {
    crossing.insert(crossing.end(), pair.begin(), pair.end());
  }
  std::sort(crossing.begin(), crossing.end());
  crossing.erase(std::unique(crossing.begin(), crossing.end()), crossing.end());
  return crossing;
}

/** Makes new points of some facets one with corners of them that are too near. */
void Resolver::MergePoints(const std::vector<Id>& candidates)
{
  std::vector<Id> points;
  for (const Id f : candidates)
  {
    points.insert(points.end(), this->Now.Facets[f].begin(), this->Now.Facets[f].end());
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  // Input points come first, and stay.
  PointIndex nearby(SnappingRadius(this->Size));
  std::unordered_map<Id, Id> merged;
  for (const Id p : points)
  {
    const Id near = nearby.Find(this->Now.Points[p]);
    if (near != None && p >= static_cast<Id>(this->Surface.Points.size()))
    {
      merged[p] = near;
    }
    else
    {
      nearby.Add(this->Now.Points[p], p);
    }
  }
  if (merged.empty())
  {
    return;
  }
  Replacement replacement;
  for (Id f = 0; f < static_cast<Id>(this->Now.Facets.size()); ++f)
  {
    Triangle corners = this->Now.Facets[f];
    for (Id& p : corners)
    {
      const auto found = merged.find(p);
      p = found == merged.end() ? p : found->second;
    }
    if (corners != this->Now.Facets[f])
    {
      replacement.Removed.push_back(f);
      if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
      {
        replacement.Added.push_back({ corners, f });
      }
    }
  }
  this->Apply(replacement);
  this->Collapse(this->DegenerateFacets());
}

/** Collapses slivers among some facets. */
void Resolver::Collapse(const std::vector<Id>& candidates)
{
  if (candidates.empty())
  {
    return;
  }
  this->Apply(
    CollapseSlivers(this->Now.Points, this->Now.Facets, candidates, SnappingRadius(this->Size)));
}

void Resolver::Apply(const Replacement& replacement)
{
  std::vector<char> isRemoved(this->Now.Facets.size(), 0);
  for (const Id f : replacement.Removed)
  {
    isRemoved[f] = 1;
  }
  std::vector<CutFacet> parts;
  for (const ReplacedFacet& part : replacement.Added)
  {
    parts.push_back({ part.Corners, this->MeaningOf(this->Now.MeaningIds[part.Parent]) });
  }
  this->Replace(std::move(isRemoved), std::move(parts));
}

/** Takes facets away and adds others, behind those that stay. */
void Resolver::Replace(std::vector<char> isRemoved, std::vector<CutFacet> added)
{
  this->AddFacets(std::move(added), isRemoved);
  std::vector<Id> kept(this->Now.Facets.size(), None);
  Id count = 0;
  Id firstUnchecked = 0;
  for (std::size_t f = 0; f < this->Now.Facets.size(); ++f)
  {
    if (isRemoved[f])
    {
      continue;
    }
    this->Now.Facets[count] = this->Now.Facets[f];
    this->Now.MeaningIds[count] = this->Now.MeaningIds[f];
    kept[f] = count++;
    firstUnchecked = static_cast<Id>(f) < this->Now.FirstUnchecked ? count : firstUnchecked;
  }
  this->Now.Facets.resize(count);
  this->Now.MeaningIds.resize(count);
  this->Now.FirstUnchecked = firstUnchecked;
  Pairs crossings;
  for (const auto& pair : this->Now.Crossings)
  {
    if (kept[pair[0]] != None && kept[pair[1]] != None)
    {
      crossings.push_back({ kept[pair[0]], kept[pair[1]] });
    }
  }
  this->Now.Crossings = std::move(crossings);
}

/** Finds the crossings of the facets that were not searched yet. */
void Resolver::FindCrossings()
{
  const Pairs found =
    FindIntersections(this->Now.Points, this->Now.Facets, this->Now.FirstUnchecked, this->Watch);
  this->Now.Crossings.insert(this->Now.Crossings.end(), found.begin(), found.end());
  std::sort(this->Now.Crossings.begin(), this->Now.Crossings.end());
  this->Now.FirstUnchecked = static_cast<Id>(this->Now.Facets.size());
}

/**
 * Adds facets, or what they mean to the ones with the same corners. What is left without a meaning
 * is marked as removed, too.
 */
void Resolver::AddFacets(std::vector<CutFacet> facets, std::vector<char>& isRemoved)
{
  std::vector<char> touched(this->Now.Points.size(), 0);
  for (const CutFacet& facet : facets)
  {
    touched[facet.Corners[0]] = touched[facet.Corners[1]] = touched[facet.Corners[2]] = 1;
  }
  std::unordered_map<Triangle, Id, HashOfTriangle> known;
  for (Id f = 0; f < static_cast<Id>(this->Now.Facets.size()); ++f)
  {
    const Triangle& corners = this->Now.Facets[f];
    if (!isRemoved[f] && touched[corners[0]] && touched[corners[1]] && touched[corners[2]])
    {
      known.insert({ SortedTriangle(corners).Points, f });
    }
  }
  for (CutFacet& facet : facets)
  {
    const SortedTriangle sorted(facet.Corners);
    const Id next = static_cast<Id>(this->Now.Facets.size());
    const auto inserted = known.insert({ sorted.Points, next });
    if (inserted.second)
    {
      this->Now.Facets.push_back(facet.Corners);
      isRemoved.push_back(facet.Means.Sources.empty());
      this->Now.MeaningIds.push_back(this->AddMeaning(std::move(facet.Means)));
      continue;
    }
    const Id same = inserted.first->second;
    Meaning sum = this->MeaningOf(this->Now.MeaningIds[same]);
    Add(sum, facet.Means, SortedTriangle(this->Now.Facets[same]).Turned != sorted.Turned);
    isRemoved[same] = sum.Sources.empty();
    this->Now.MeaningIds[same] = this->AddMeaning(std::move(sum));
  }
}

Id Resolver::AddMeaning(Meaning meaning)
{
  this->Meanings.push_back(std::move(meaning));
  return static_cast<Id>(this->Surface.Facets.size() + this->Meanings.size() - 1);
}

/** The meaning with this number: a given facet's, or beyond those a piece's. */
Meaning Resolver::MeaningOf(Id meaning) const
{
  const Id given = this->Surface.NumberOfFacets();
  return meaning < given ? MeaningOfGiven(this->Surface, meaning) : this->Meanings[meaning - given];
}

Id Resolver::RootOf(Id meaning) const
{
  const Id given = this->Surface.NumberOfFacets();
  return meaning < given ? meaning : this->Meanings[meaning - given].Root;
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
  // Several pieces of one triangle may lie on each other; it is named once.
  std::unique_copy(meaning.Sources.begin(), meaning.Sources.end(),
    std::back_inserter(surface.Sources),
    [](const FacetSource& a, const FacetSource& b) { return a.Triangle == b.Triangle; });
  surface.SourceOffsets.push_back(static_cast<Id>(surface.Sources.size()));
}

/** Drops new points that no facet has any more. */
void Resolver::DropUnusedPoints()
{
  const std::size_t given = this->Surface.Points.size();
  std::vector<Id> places(this->Now.Points.size(), None);
  for (const Triangle& t : this->Now.Facets)
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
      this->Now.Points[count] = this->Now.Points[p];
      this->Roots[count - given] = this->Roots[p - given];
      places[p] = static_cast<Id>(count++);
    }
  }
  this->Now.Points.resize(count);
  for (Triangle& t : this->Now.Facets)
  {
    t = { places[t[0]], places[t[1]], places[t[2]] };
  }
}

/** The constraints, then what is left out of them, then what the given complex had left out. */
FacetComplex Resolver::Assemble(const std::vector<Id>& leftOut)
{
  this->DropUnusedPoints();
  FacetComplex surface;
  auto next = leftOut.begin();
  for (Id f = 0; f < static_cast<Id>(this->Now.Facets.size()); ++f)
  {
    if (next != leftOut.end() && *next == f)
    {
      ++next;
      continue;
    }
    Append(surface, this->Now.Facets[f], this->MeaningOf(this->Now.MeaningIds[f]));
  }
  surface.NumberOfConstraints = surface.NumberOfFacets();
  for (const Id f : leftOut)
  {
    Append(surface, this->Now.Facets[f], this->MeaningOf(this->Now.MeaningIds[f]));
  }
  for (Id f = this->Surface.NumberOfConstraints; f < this->Surface.NumberOfFacets(); ++f)
  {
    Append(surface, this->Surface.Facets[f], MeaningOfGiven(this->Surface, f));
  }
  surface.Points = std::move(this->Now.Points);
  surface.Origins = this->OriginsOf(surface.Points);
  return surface;
}

/** Where points come from: the given ones as they were, new ones from the facet they lie on. */
std::vector<PointOrigin> Resolver::OriginsOf(const std::vector<Point>& points) const
{
  std::vector<PointOrigin> origins = this->Surface.Origins;
  const Id given = static_cast<Id>(origins.size());
  origins.resize(points.size());
  ParallelLoop(static_cast<Id>(points.size()) - given, this->Watch, { Stage, 1, 1 },
    [&](Id i)
    {
      const Triangle& corners = this->Surface.Facets[this->Roots[i]];
      PointOrigin& origin = origins[given + i];
      std::array<Point, 3> triangle;
      for (int k = 0; k < 3; ++k)
      {
        origin.Points[k] = this->Surface.Origins[corners[k]].Points[0];
        triangle[k] = this->Surface.Points[corners[k]];
      }
      origin.Weights = BarycentricWeights(triangle, points[given + i]);
    });
  return origins;
}
} // namespace

Resolution ResolveSelfIntersections(const FacetComplex& surface, Monitor& monitor)
{
  return Resolver(surface, monitor).Resolve();
}
} // namespace insideout
