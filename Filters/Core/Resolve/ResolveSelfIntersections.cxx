// SPDX-License-Identifier: GPL-3.0-or-later
#include "Resolve/ResolveSelfIntersections.h"

#include "Common/Box.h"
#include "Common/ParallelLoop.h"
#include "Common/ScaledPoints.h"
#include "Common/SortUniquely.h"
#include "Common/Stages.h"
#include "Common/Vectors.h"
#include "Resolve/CollapseSlivers.h"
#include "Resolve/CutFacets.h"
#include "Resolve/CutLayers.h"
#include "Resolve/FindTangles.h"
#include "Resolve/PointIndex.h"
#include "Resolve/SnappingRadius.h"
#include "Resolve/SplitAlike.h"
#include "Resolve/SplitAtLoosePoints.h"
#include "Resolve/WorkingSurface.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>
#include <unordered_map>

namespace insideout
{
namespace
{
/**
 * Limit of rounds; facets that still cross are left out. Most real models take one to three rounds.
 * With SnappingRadius it limits the movement of points to 1e-12 of the largest coordinate.
 */
constexpr int MaximumRounds = 10;

/** Stop after this number of rounds without a new minimum of crossings. */
constexpr int Patience = 6;

/**
 * Stop when there are this many times more crossings than the minimum: facets in nearly one plane
 * may cross along ever more lines.
 */
constexpr std::size_t Divergence = 4;

/**
 * The facets to leave out so that each pair loses one. Greedily, the facet in most pairs comes
 * first; on ties the last facet.
 */
std::vector<Id> CoverOf(std::vector<std::array<Id, 2>> pairs)
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

std::string WordsOf(const Tangle& tangle)
{
  std::ostringstream words;
  words << tangle.Facets.size() << " facets cross each other in " << tangle.Crossings
        << " points near (" << tangle.Center[0] << ", " << tangle.Center[1] << ", "
        << tangle.Center[2] << "): they are bent by up to " << tangle.Distance
        << ", to meet in one point there";
  return words.str();
}

class Resolver
{
public:
  Resolver(FacetComplex surface, Monitor& monitor);
  Resolution Resolve(
    const KnownCrossings& known, const TouchingFacets& touching, const std::vector<Id>& mayTouch);

private:
  std::vector<std::string> JoinTangles();
  Id PlaceCenter(const Tangle& tangle);
  void CutRepeatedly();
  void Cut(const ProgressRange& progress);
  void MergeTouching(const TouchingFacets& touching);
  void MergeLayers(const std::vector<std::array<Id, 2>>& pairs);
  void TakeAlike(const std::vector<PlanarSubdivision>& subdivisions, double radius);
  std::vector<std::vector<Id>> TakePieces(
    const std::vector<PlanarSubdivision>& subdivisions, double radius);
  void TakePositions(const std::vector<Point>& wanted);
  void PrepareSnapping(const std::vector<char>& isCut, double radius);
  std::vector<std::vector<Id>> PlacePoints(const std::vector<PlanarSubdivision>& subdivisions);
  Id PlacePoint(const Point& p, Id root);
  void MergePoints(const std::vector<Id>& candidates);
  void Collapse(const std::vector<Id>& candidates)
  {
    this->Collapse(candidates, SnappingRadius(this->Size));
  }
  void Collapse(const std::vector<Id>& candidates, double radius);
  std::vector<MeantFacet> PlacedPieces(const std::vector<PlanarSubdivision>& subdivisions,
    const std::vector<std::vector<Id>>& ids) const;

  Monitor& Watch;
  const double Size; ///< the largest coordinate
  int Round = 0;

  FacetComplex Given; ///< its points and origins move to the next one
  WorkingSurface Now;

  PointIndex Positions{ 0 }; ///< points where the names of this round are placed
  PointIndex Nearby{ 0 };    ///< points that new points of this round may snap to
  PointIndex Moved{ 0 };     ///< points snapped in this round, by their former positions
};

Resolver::Resolver(FacetComplex surface, Monitor& monitor)
  : Watch(monitor)
  , Size(LargestCoordinate(surface.Points))
  , Given(std::move(surface))
  , Now(this->Given)
{
}

Resolution Resolver::Resolve(
  const KnownCrossings& known, const TouchingFacets& touching, const std::vector<Id>& mayTouch)
{
  if (known.SetOf.empty())
  {
    this->Now.FindCrossings(this->Watch);
  }
  else
  {
    this->Now.FindCrossingsBetween(known.SetOf, known.NearOthers, known.Pairs, this->Watch);
  }
  Resolution resolution;
  resolution.IntersectingPairs = this->Now.Crossings;
  const std::vector<std::array<Id, 2>> layers = FindLayers({ this->Now.Points, this->Now.Facets },
    mayTouch, SnappingRadius(this->Size), this->Watch, { Stages::Resolving, 0, 0 });
  if (!this->Now.Crossings.empty() || !layers.empty() || !touching.Pairs.empty())
  {
    this->MergeTouching(touching);
    this->MergeLayers(layers);
    resolution.Warnings = this->JoinTangles();
    this->CutRepeatedly();
  }
  resolution.Rounds = this->Round;
  resolution.Surface =
    SplitAtLoosePoints(this->Now.Assemble(CoverOf(this->Now.Crossings), this->Watch), this->Watch,
      { Stages::Resolving, 1, 1 });
  this->Watch.Check(Stages::Resolving, 1);
  return resolution;
}

/** The id of the point at a tangle's center: one that is there up to rounding, or a new one. */
Id Resolver::PlaceCenter(const Tangle& tangle)
{
  const std::vector<Point>& points = this->Now.Points;
  const auto there = std::find_if(points.begin(), points.end(),
    [&](const Point& p) { return Distance(p, tangle.Center) <= SnappingRadius(this->Size); });
  return there != points.end()
    ? static_cast<Id>(there - points.begin())
    : this->Now.AddPoint(tangle.Center, this->Now.RootOf(tangle.Facets[0]));
}

/**
 * Split the edges and facets of each tangle at its center, as if it lay on them: those along an
 * edge alike, so that closed chains stay closed. @return a warning for each tangle that is bent
 */
std::vector<std::string> Resolver::JoinTangles()
{
  const std::vector<Tangle> tangles = FindTangles({ this->Now.Points, this->Now.Facets },
    this->Now.Crossings, this->Watch, { Stages::Resolving, 0, 0 });
  if (tangles.empty())
  {
    return {};
  }
  std::vector<std::string> warnings;
  SplittableFacets splittable(this->Now.Points.size(), this->Now.Facets);
  for (const Tangle& tangle : tangles)
  {
    const Id center = this->PlaceCenter(tangle);
    for (const Edge& edge : tangle.Edges)
    {
      if (edge[0] != center && edge[1] != center)
      {
        splittable.Split(edge, center);
      }
    }
    for (const Id f : tangle.Facets)
    {
      if (splittable.IsThere(f) && !HasCorner(this->Now.Facets[f], center))
      {
        splittable.SplitFacet(f, center);
      }
    }
    if (tangle.Distance > SnappingRadius(this->Size))
    {
      warnings.push_back(WordsOf(tangle));
    }
  }
  this->Now.Apply(splittable.Result());
  this->Collapse(this->Now.DegenerateFacets());
  this->Now.FindCrossings(this->Watch);
  return warnings;
}

/** Cut until nothing crosses; otherwise restore the round with the fewest crossing facets. */
void Resolver::CutRepeatedly()
{
  std::optional<WorkingSurface> best;
  int bestRound = 0;
  while (!this->Now.Crossings.empty() && this->Round < MaximumRounds)
  {
    ++this->Round;
    // The number of rounds is unknown: each takes half of the remaining progress.
    const double begin = 1 - std::ldexp(1.0, 1 - this->Round);
    const double end = 1 - std::ldexp(1.0, -this->Round);
    this->MergeLayers(this->Now.Crossings);
    this->Cut({ Stages::Resolving, begin, end });
    this->Collapse(this->Now.DegenerateFacets());
    this->Now.FindCrossings(this->Watch);
    this->MergePoints(this->Now.CrossingFacets());
    this->Now.FindCrossings(this->Watch);
    this->Collapse(this->Now.CrossingFacets());
    this->Now.FindCrossings(this->Watch);
    const std::size_t count = this->Now.Crossings.size();
    if (count == 0)
    {
      return;
    }
    if (!best || count < best->Crossings.size())
    {
      best = this->Now;
      bestRound = this->Round;
    }
    if (count > Divergence * best->Crossings.size() || this->Round - bestRound == Patience)
    {
      break;
    }
  }
  if (best)
  {
    this->Now = std::move(*best);
  }
}

/** Merge layers: facets of these pairs that lie in nearly one plane. */
void Resolver::MergeLayers(const std::vector<std::array<Id, 2>>& pairs)
{
  const double radius = SnappingRadius(this->Size);
  const std::vector<PlanarSubdivision> subdivisions =
    CutLayers({ this->Now.Points, this->Now.Facets }, pairs, radius, this->Watch,
      { Stages::Resolving, 0, 0 });
  if (!subdivisions.empty())
  {
    this->TakeAlike(subdivisions, radius);
    this->Collapse(this->Now.DegenerateFacets());
    this->Now.FindCrossings(this->Watch);
  }
}

/** Replace facets by their pieces, and split their neighbors along the shared edges alike. */
void Resolver::TakeAlike(const std::vector<PlanarSubdivision>& subdivisions, double radius)
{
  const std::vector<std::vector<Id>> ids = this->TakePieces(subdivisions, radius);
  std::vector<EdgeChain> chains;
  for (std::size_t s = 0; s < subdivisions.size(); ++s)
  {
    const std::vector<EdgeChain> more = ChainsOf(subdivisions[s], ids[s]);
    chains.insert(chains.end(), more.begin(), more.end());
  }
  this->Now.Apply(SplitAlike(this->Now.Points, this->Now.Facets, chains));
}

/** Merge facets that are meant to coincide. */
void Resolver::MergeTouching(const TouchingFacets& touching)
{
  if (touching.Pairs.empty())
  {
    return;
  }
  this->TakeAlike(CutTouching({ this->Now.Points, this->Now.Facets }, touching.Pairs, this->Watch,
                    { Stages::Resolving, 0, 0 }),
    touching.Radius);
  this->Collapse(this->Now.UncheckedFacets(), touching.Radius);
  this->Now.FindCrossings(this->Watch);
}

/** Cut the facets that cross. */
void Resolver::Cut(const ProgressRange& progress)
{
  this->Watch.Check(Stages::Resolving, progress.Begin);
  const std::vector<PlanarSubdivision> subdivisions =
    CutFacets({ this->Now.Points, this->Now.Facets }, this->Now.Crossings, this->Watch, progress);
  this->TakePieces(subdivisions, this->Round == 1 ? 0 : SnappingRadius(this->Size));
  this->Watch.Check(Stages::Resolving, progress.End);
}

/**
 * Replace the subdivided facets by their pieces. New points within the radius of a facet's corner,
 * or of each other, are merged.
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
  this->Now.Replace(std::move(isCut), this->PlacedPieces(subdivisions, ids));
  return ids;
}

/** Record the points at wanted positions. */
void Resolver::TakePositions(const std::vector<Point>& wanted)
{
  const Box box = BoundingBox(wanted);
  PointIndex index(0);
  for (std::size_t i = 0; i < wanted.size(); ++i)
  {
    index.Add(wanted[i], static_cast<Id>(i));
  }
  std::vector<char> isWanted(this->Now.Points.size(), 0);
  const double nanosecondsPerPoint = 5;
  ParallelLoop(isWanted.size(), nanosecondsPerPoint,
    [&](std::size_t p)
    {
      const Point& place = this->Now.Points[p];
      isWanted[p] = box.Holds(place) && index.Find(place) != None;
    });
  this->Positions = PointIndex(0);
  for (std::size_t p = 0; p < isWanted.size(); ++p)
  {
    if (isWanted[p])
    {
      this->Positions.Add(this->Now.Points[p], static_cast<Id>(p));
    }
  }
}

void Resolver::PrepareSnapping(const std::vector<char>& isCut, double radius)
{
  this->Moved = PointIndex(0);
  this->Nearby = PointIndex(radius);
  std::vector<char> added(this->Now.Points.size(), 0);
  for (Id f = 0; f < static_cast<Id>(this->Now.Facets.size()); ++f)
  {
    for (int k = 0; isCut[f] && k < 3; ++k)
    {
      const Id p = this->Now.Facets[f][k];
      if (!added[p])
      {
        this->Nearby.Add(this->Now.Points[p], p);
        added[p] = 1;
      }
    }
  }
}

/**
 * Give every point of the subdivisions a position: each name is rounded once.
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
  SortUniquely(names);

  std::vector<Point> rounded(names.size());
  const FacetList facets{ this->Now.Points, this->Now.Facets };
  const double nanosecondsPerName = 1000; // to construct and round it
  ParallelLoop(static_cast<Id>(names.size()), nanosecondsPerName, this->Watch,
    { Stages::Resolving, 0, 0 }, [&](Id i) { rounded[i] = Nearest(names[i], facets); });
  this->TakePositions(rounded);

  std::vector<Id> placed(names.size(), None);
  std::vector<std::vector<Id>> ids;
  for (const PlanarSubdivision& subdivision : subdivisions)
  {
    ids.emplace_back(subdivision.Points.size(), None);
    for (const Piece& piece : subdivision.Pieces)
    {
      const Id root = this->Now.RootOf(piece.Sources[0].Facet);
      for (const Id p : piece.Corners)
      {
        if (ids.back()[p] != None)
        {
          continue;
        }
        const Id at = IndexIn(names, subdivision.Points[p]);
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

/**
 * The id of the point at p: an existing one there, in later rounds also one near it, or a new one.
 */
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
  const Id id = this->Now.AddPoint(p, root);
  this->Positions.Add(p, id);
  this->Nearby.Add(p, id);
  return id;
}

/** The pieces with their points placed, without those that have a point twice. */
std::vector<MeantFacet> Resolver::PlacedPieces(
  const std::vector<PlanarSubdivision>& subdivisions, const std::vector<std::vector<Id>>& ids) const
{
  std::vector<MeantFacet> facets;
  for (std::size_t s = 0; s < subdivisions.size(); ++s)
  {
    for (const Piece& piece : subdivisions[s].Pieces)
    {
      MeantFacet facet;
      for (int k = 0; k < 3; ++k)
      {
        facet.Corners[k] = ids[s][piece.Corners[k]];
      }
      if (facet.Corners[0] == facet.Corners[1] || facet.Corners[1] == facet.Corners[2] ||
        facet.Corners[2] == facet.Corners[0])
      {
        continue;
      }
      facet.Means.Root = this->Now.RootOf(piece.Sources[0].Facet);
      for (const PieceSource& source : piece.Sources)
      {
        Add(facet.Means, this->Now.MeaningOf(source.Facet), source.Reversed);
      }
      facets.push_back(std::move(facet));
    }
  }
  return facets;
}

/** Merge new points of some facets with corners of these facets that are too near. */
void Resolver::MergePoints(const std::vector<Id>& candidates)
{
  std::vector<Id> points;
  for (const Id f : candidates)
  {
    points.insert(points.end(), this->Now.Facets[f].begin(), this->Now.Facets[f].end());
  }
  SortUniquely(points);
  // Input points come first, and stay.
  PointIndex nearby(SnappingRadius(this->Size));
  std::unordered_map<Id, Id> merged;
  for (const Id p : points)
  {
    const Id near = nearby.Find(this->Now.Points[p]);
    if (near != None && p >= this->Now.NumberOfGivenPoints())
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
  this->Now.Apply(replacement);
  this->Collapse(this->Now.DegenerateFacets());
}

/** Collapse slivers among some facets. */
void Resolver::Collapse(const std::vector<Id>& candidates, double radius)
{
  if (candidates.empty())
  {
    return;
  }
  this->Now.Apply(CollapseSlivers(this->Now.Points, this->Now.Facets, candidates, radius));
}
} // namespace

Resolution ResolveSelfIntersections(FacetComplex surface, Monitor& monitor,
  const KnownCrossings& known, const TouchingFacets& touching, const std::vector<Id>& mayTouch)
{
  return Resolver(std::move(surface), monitor).Resolve(known, touching, mayTouch);
}
} // namespace insideout
