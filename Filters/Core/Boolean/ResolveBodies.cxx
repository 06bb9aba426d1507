// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/ResolveBodies.h"

#include "Boolean/CloseGaps.h"
#include "Boolean/NearBodies.h"
#include "Boolean/TouchBodies.h"
#include "Common/DisjointSets.h"
#include "Common/JobsAtOnce.h"
#include "Common/ScaledPoints.h"
#include "Common/SortUniquely.h"
#include "Common/SortedTriangle.h"
#include "Common/Stages.h"
#include "Common/Team.h"
#include "Common/Vectors.h"
#include "Resolve/FacetsNearOthers.h"
#include "Resolve/FindIntersections.h"
#include "Resolve/ResolveSelfIntersections.h"
#include "Resolve/SnappingRadius.h"
#include "Validate/FacetSources.h"
#include "Validate/MergePoints.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <unordered_map>

namespace insideout
{
namespace
{
/** @throws Error TooLarge */
void SetMultiplicity(const std::vector<int>& multiplicity, FacetComplex& surface)
{
  surface.Multiplicity.clear();
  for (const int count : multiplicity)
  {
    if (std::abs(count) > std::numeric_limits<std::int16_t>::max())
    {
      throw Error(ErrorCode::TooLarge,
        "bodies have a facet in common that counts " + std::to_string(count) +
          " times; at most 32767 can be counted");
    }
    surface.Multiplicity.push_back(static_cast<std::int16_t>(count));
  }
}

/** All numbers of points are below this. */
Id NumberOfPointIds(const std::vector<Body>& bodies)
{
  Id number = 0;
  for (const Body& body : bodies)
  {
    for (const Id id : body.PointIds)
    {
      number = std::max(number, id + 1);
    }
  }
  return number;
}

/** The orientation of one body, by the numbers of its triangles. */
struct BodyTurns
{
  std::vector<Id> Turned;
  std::vector<Id> Sheets;
  std::vector<HoledShell> Holed;
};

/**
 * Bodies are processed in parallel if the largest is at most this multiple of a thread's fair
 * share.
 */
constexpr double MostUneven = 1.25;

/**
 * Threads kept busy by counting or orienting one body: nearly half of that work runs on one thread.
 */
constexpr int ThreadsOfABody = 2;

/** Room for points of cuts, so that no list of points is copied when they are appended. */
constexpr std::size_t PointsPerSparePoint = 16;

class BodyResolver
{
public:
  BodyResolver(std::vector<Body> bodies, const BodyParameters& parameters, Monitor& monitor)
    : Given(std::move(bodies))
    , Parameters(parameters)
    , Watch(monitor)
    , NumberOfIds(NumberOfPointIds(this->Given))
    , SamePoints(static_cast<std::size_t>(this->NumberOfIds))
    , Chains(this->Given.size())
    , Edges(this->Given.size())
    , OwnCrossings(this->Given.size())
  {
    this->Result.Bodies.resize(this->Given.size());
  }

  ResolvedBodies Resolve();

private:
  void MergeGivenPoints();
  void ForEachBody(
    const char* stage, int threads, const std::function<void(std::size_t, Monitor&)>& work);
  CountedChain CountFacetsOf(
    const Body& body, const CountedChainParameters& parameters, Monitor& monitor) const;
  void CountFacetsOfBodies();
  void FindOwnCrossings();
  BodyTurns OrientBody(std::size_t b, Monitor& monitor);
  void OrientBodies();
  bool Thickens() const { return this->Parameters.Thicken.Width != 0; }
  void ResolveAlone();
  void ResolveTogether();
  struct JoinedPoint
  {
    Id Number;     ///< of the joined points
    bool IsShared; ///< several points are this one
  };
  FacetComplex ChainsInSequence();
  void FindNearOthers(const FacetComplex& all);
  std::vector<Id> LowestEqualPoints(const FacetComplex& all) const;
  std::vector<JoinedPoint> JoinPoints(const std::vector<Id>& lowest, FacetComplex& all);
  std::vector<FacetSource> JoinFacets(const std::vector<Id>& lowest, FacetComplex& all);
  FacetComplex Together();
  void TakeOwnCrossings(const std::vector<FacetSource>& places);
  void TakeTouching(const std::vector<FacetSource>& places);
  std::vector<Id> TakeResolved(FacetComplex resolved);
  void FindGrids();
  void Touch();
  void TellOfNearBodies(const std::vector<Id>& candidates);
  std::vector<std::string> Names() const;
  Id BodyOf(Id chainFacet) const;
  void Warn(const Body& body, const std::vector<std::string>& warnings);

  std::vector<Body> Given;
  const BodyParameters& Parameters;
  Monitor& Watch;

  const Id NumberOfIds;    ///< of points
  DisjointSets SamePoints; ///< by their numbers

  std::vector<FacetComplex>
    Chains; ///< one per body; once oriented, by the body's numbers of points and triangles
  std::vector<FacetEdges> Edges; ///< per chain, until it is oriented
  std::vector<Id> FirstFacet;    ///< per chain, if the facets of all are numbered consecutively
  std::vector<std::vector<std::array<Id, 2>>> OwnCrossings; ///< per chain, by its facets
  std::vector<std::optional<CoordinateGrid>> Grids;         ///< one per body, if there are several
  TouchingFacets Touching;  ///< by facets of the chains, in sequence, later of the whole
  KnownCrossings Known;     ///< of the whole, with a body per facet
  std::vector<char> IsNear; ///< per facet of the chains: may be near another body's after all
  ResolvedBodies Result;
};

void BodyResolver::Warn(const Body& body, const std::vector<std::string>& warnings)
{
  for (const std::string& warning : warnings)
  {
    this->Result.Warnings.push_back(WordsOf(body.Name, warning));
  }
}

/** Merge points of all bodies that are within the tolerance of each other. */
void BodyResolver::MergeGivenPoints()
{
  std::vector<Point> points;
  std::vector<Id> ids;
  for (const Body& body : this->Given)
  {
    points.insert(points.end(), body.Soup.Points.begin(), body.Soup.Points.end());
    ids.insert(ids.end(), body.PointIds.begin(), body.PointIds.end());
  }
  const std::vector<Id> merged = MergePoints(points, this->Parameters.Chain.MergeTolerance);
  std::size_t i = 0;
  for (Body& body : this->Given)
  {
    for (Point& p : body.Soup.Points)
    {
      p = points[merged[i]];
      this->SamePoints.Join(ids[i], ids[merged[i]]);
      ++i;
    }
  }
}

/** The chain of a soup whose triangles all have no area. */
CountedChain AllDegenerateChain(const TriangleSoup& soup)
{
  CountedChain chain;
  chain.Counts.InputPoints = static_cast<Id>(soup.Points.size());
  chain.Counts.InputTriangles = static_cast<Id>(soup.Triangles.size());
  chain.Counts.DegenerateFacets = chain.Counts.InputTriangles;
  chain.DegenerateTriangles.resize(soup.Triangles.size());
  std::iota(chain.DegenerateTriangles.begin(), chain.DegenerateTriangles.end(), 0);
  return chain;
}

/**
 * Process each body. If it keeps more threads busy, each thread takes a body; else all threads work
 * on one body after the other.
 * @param[in] threads of the allowed ones that one body keeps busy
 */
void BodyResolver::ForEachBody(
  const char* stage, int threads, const std::function<void(std::size_t, Monitor&)>& work)
{
  std::vector<double> sizes;
  double all = 0;
  double largest = 0;
  for (const Body& body : this->Given)
  {
    sizes.push_back(static_cast<double>(body.Soup.Triangles.size()));
    all += sizes.back();
    largest = std::max(largest, sizes.back());
  }
  const int allowed = AllowedThreads();
  const bool isEven = largest * std::min(threads, allowed) <= MostUneven * all;
  JobsAtOnce(
    sizes, isEven ? allowed : 1, stage,
    [&](std::size_t b, Monitor& own) { InTheNameOf(this->Given[b].Name, [&]() { work(b, own); }); },
    this->Watch);
}

/** Count the facets of a body. One without facets is empty if bodies have names. */
CountedChain BodyResolver::CountFacetsOf(
  const Body& body, const CountedChainParameters& parameters, Monitor& monitor) const
{
  CountedChain chain;
  try
  {
    chain = CountFacets(body.Soup, parameters, monitor);
  }
  catch (const Error& error)
  {
    if (!AreNamed(this->Given) ||
      (error.Code != ErrorCode::EmptySurface && error.Code != ErrorCode::AllDegenerate))
    {
      throw;
    }
    if (error.Code == ErrorCode::AllDegenerate)
    {
      chain = AllDegenerateChain(body.Soup);
    }
    chain.Warnings = { std::string(error.what()) + ": the body is empty" };
  }
  return chain;
}

void BodyResolver::CountFacetsOfBodies()
{
  CountedChainParameters parameters = this->Parameters.Chain;
  if (this->Given.size() > 1)
  {
    parameters.MergeTolerance = std::min(parameters.MergeTolerance, 0.0); // merged already
  }
  std::vector<CountedChain> chains(this->Given.size());
  this->ForEachBody(Stages::Validating, ThreadsOfABody,
    [&](std::size_t b, Monitor& monitor)
    { chains[b] = this->CountFacetsOf(this->Given[b], parameters, monitor); });
  bool isAnyThere = false;
  for (std::size_t b = 0; b < this->Given.size(); ++b)
  {
    const Body& body = this->Given[b];
    CountedChain& chain = chains[b];
    isAnyThere |= !chain.Surface.Facets.empty();
    for (std::size_t p = 0; p < chain.MergedInto.size(); ++p)
    {
      this->SamePoints.Join(body.PointIds[p], body.PointIds[chain.MergedInto[p]]);
    }
    for (const Id t : chain.DegenerateTriangles)
    {
      this->Result.DegenerateTriangles.push_back(body.TriangleIds[t]);
    }
    this->Warn(body, chain.Warnings);
    this->Result.Bodies[b].Counts = chain.Counts;
    this->Chains[b] = std::move(chain.Surface);
    this->Edges[b] = std::move(chain.Edges);
  }
  if (!isAnyThere)
  {
    throw Error(ErrorCode::EmptySurface, "none of the bodies has a polygon with an area");
  }
}

/** Find crossings in each body once: here, or after it is thickened. */
void BodyResolver::FindOwnCrossings()
{
  this->ForEachBody(Stages::FindingIntersections, AllowedThreads(),
    [&](std::size_t b, Monitor& monitor)
    {
      const FacetComplex& chain = this->Chains[b];
      this->OwnCrossings[b] = FindIntersections(chain.Points, chain.Facets, monitor);
    });
}

/** Replace indices into a body's soup by the body's numbers of points and triangles. */
void GiveNumbers(const Body& body, FacetComplex& chain)
{
  for (PointOrigin& origin : chain.Origins)
  {
    for (Id& p : origin.Points)
    {
      p = body.PointIds[p];
    }
  }
  for (FacetSource& source : chain.Sources)
  {
    source.Triangle = body.TriangleIds[source.Triangle];
  }
}

std::vector<HoledShell> HoledShellsOf(
  const FacetComplex& chain, const FacetTurns& turns, const Body& body)
{
  std::vector<HoledShell> shells;
  std::vector<Id> places(turns.ShellVolumes.size(), None);
  for (Id shell = 0; shell < static_cast<Id>(places.size()); ++shell)
  {
    if (turns.ShellHasHoles[shell] && turns.ShellVolumes[shell] > 0)
    {
      places[shell] = static_cast<Id>(shells.size());
      shells.push_back({ body.Name, shell, turns.ShellVolumes[shell], {} });
    }
  }
  for (Id f = 0; !shells.empty() && f < chain.NumberOfFacets(); ++f)
  {
    const Id shell = turns.Shell[f];
    for (Id s = chain.SourceOffsets[f];
         shell != None && places[shell] != None && s < chain.SourceOffsets[f + 1]; ++s)
    {
      shells[places[shell]].Triangles.push_back(body.TriangleIds[chain.Sources[s].Triangle]);
    }
  }
  return shells;
}

/** Orient and thicken a body, and number its chain by the body's numbers. */
BodyTurns BodyResolver::OrientBody(std::size_t b, Monitor& monitor)
{
  const Body& body = this->Given[b];
  FacetComplex& chain = this->Chains[b];
  FacetTurns& turns = this->Result.Bodies[b].Turns;
  turns = OrientFacets(chain, this->Edges[b], this->Parameters.Orientation, monitor,
    this->Thickens() || !this->OwnCrossings[b].empty() ? Crossings::Unknown : Crossings::Absent);
  this->Edges[b] = {};
  const auto numbers = [&](const std::vector<char>& marks)
  {
    std::vector<Id> triangles = TrianglesOfFacets(chain, marks);
    for (Id& t : triangles)
    {
      t = body.TriangleIds[t];
    }
    return triangles;
  };
  BodyTurns told = { numbers(turns.Turned), numbers(turns.IsSheet),
    HoledShellsOf(chain, turns, body) };
  this->Result.Bodies[b].ThickenedFacets =
    ThickenFacets(chain, turns.IsSheet, this->Parameters.Thicken, monitor);
  if (this->Thickens())
  {
    this->OwnCrossings[b] = FindIntersections(chain.Points, chain.Facets, monitor);
  }
  GiveNumbers(body, chain);
  return told;
}

void BodyResolver::OrientBodies()
{
  std::vector<BodyTurns> told(this->Given.size());
  this->ForEachBody(Stages::Orienting, ThreadsOfABody,
    [&](std::size_t b, Monitor& monitor)
    {
      if (!this->Chains[b].Facets.empty())
      {
        told[b] = this->OrientBody(b, monitor);
      }
    });
  const auto append = [](auto& all, const auto& some)
  { all.insert(all.end(), some.begin(), some.end()); };
  for (std::size_t b = 0; b < this->Given.size(); ++b)
  {
    append(this->Result.TurnedTriangles, told[b].Turned);
    append(this->Result.SheetTriangles, told[b].Sheets);
    append(this->Result.HoledShells, told[b].Holed);
    const FacetTurns& turns = this->Result.Bodies[b].Turns;
    this->Warn(this->Given[b], turns.Warnings);
    if (!this->Thickens())
    {
      this->Warn(this->Given[b], turns.UncountedWarnings);
    }
  }
}

/** The facets of all chains as one complex, with equal points of different bodies. */
FacetComplex BodyResolver::ChainsInSequence()
{
  FacetComplex all;
  std::size_t points = 0;
  std::size_t facets = 0;
  for (const FacetComplex& chain : this->Chains)
  {
    points += chain.Points.size();
    facets += chain.Facets.size();
  }
  all.Points.reserve(points + points / PointsPerSparePoint);
  all.Origins.reserve(points + points / PointsPerSparePoint);
  all.Facets.reserve(facets);
  all.Multiplicity.reserve(facets);
  this->Known.SetOf.reserve(facets);
  const auto append = [](const auto& some, auto& to)
  { to.insert(to.end(), some.begin(), some.end()); };
  for (std::size_t b = 0; b < this->Chains.size(); ++b)
  {
    FacetComplex& chain = this->Chains[b];
    this->FirstFacet.push_back(all.NumberOfFacets());
    const Id first = static_cast<Id>(all.Points.size());
    for (const Triangle& corners : chain.Facets)
    {
      all.Facets.push_back({ corners[0] + first, corners[1] + first, corners[2] + first });
    }
    append(chain.Points, all.Points);
    append(chain.Origins, all.Origins);
    append(chain.Multiplicity, all.Multiplicity);
    this->Known.SetOf.insert(this->Known.SetOf.end(), chain.Facets.size(), static_cast<Id>(b));
    chain.Points = {};
    chain.Origins = {};
    chain.Facets = {};
  }
  return all;
}

/** Find the facets that are near other bodies, or may be once all are cut. */
void BodyResolver::FindNearOthers(const FacetComplex& all)
{
  const double size = LargestCoordinate(all.Points);
  this->Known.NearOthers = FacetsNearOthers(all.Points, all.Facets, this->Known.SetOf,
    SnappingRadius(size) + LargestShift(size) + this->Touching.Radius);
  this->IsNear.resize(all.Facets.size(), 0);
  for (const Id f : this->Known.NearOthers)
  {
    this->IsNear[f] = 1;
  }
}

/** Per point the lowest one with the same coordinates; empty if no two are equal. */
std::vector<Id> BodyResolver::LowestEqualPoints(const FacetComplex& all) const
{
  // No two points of a chain are equal, except perhaps those of slabs.
  std::vector<char> mayBeEqual(all.Points.size(), this->Thickens() ? 1 : 0);
  for (const Id f : this->Known.NearOthers)
  {
    for (const Id p : all.Facets[f])
    {
      mayBeEqual[p] = 1;
    }
  }
  std::vector<Id> some;
  std::vector<Point> places;
  for (std::size_t p = 0; p < mayBeEqual.size(); ++p)
  {
    if (mayBeEqual[p])
    {
      some.push_back(static_cast<Id>(p));
      places.push_back(all.Points[p]);
    }
  }
  const std::vector<Id> merged = MergePoints(places, 0);
  std::vector<Id> lowest;
  for (std::size_t i = 0; i < some.size(); ++i)
  {
    if (merged[i] != static_cast<Id>(i))
    {
      if (lowest.empty())
      {
        lowest.resize(all.Points.size());
        std::iota(lowest.begin(), lowest.end(), 0);
      }
      lowest[some[i]] = some[merged[i]];
    }
  }
  return lowest;
}

/**
 * Make one point of equal points.
 * @return per point of the former ones whether others are the same, and its number
 */
std::vector<BodyResolver::JoinedPoint> BodyResolver::JoinPoints(
  const std::vector<Id>& lowest, FacetComplex& all)
{
  std::vector<JoinedPoint> joined(lowest.size(), { None, false });
  std::size_t kept = 0;
  for (std::size_t p = 0; p < lowest.size(); ++p)
  {
    const std::size_t first = static_cast<std::size_t>(lowest[p]);
    if (first == p)
    {
      joined[p].Number = static_cast<Id>(kept);
      all.Points[kept] = all.Points[p];
      all.Origins[kept] = all.Origins[p];
      ++kept;
      continue;
    }
    joined[first].IsShared = true;
    joined[p] = joined[first];
    const PointOrigin& origin = all.Origins[joined[first].Number];
    if (all.Origins[p].IsInput() && origin.IsInput())
    {
      this->SamePoints.Join(all.Origins[p].Points[0], origin.Points[0]);
    }
  }
  all.Points.resize(kept);
  all.Origins.resize(kept);
  return joined;
}

/**
 * Make one point of equal points, and one facet of equal facets.
 * @return per facet of the former ones, its facet and whether it is turned
 */
std::vector<FacetSource> BodyResolver::JoinFacets(const std::vector<Id>& lowest, FacetComplex& all)
{
  const std::vector<JoinedPoint> joined = this->JoinPoints(lowest, all);
  std::unordered_map<Triangle, FacetSource, HashOfTriangle> known; // of shared points
  std::vector<FacetSource> places;
  std::vector<int> multiplicity;
  places.reserve(all.Facets.size());
  multiplicity.reserve(all.Facets.size());
  Id facets = 0;
  for (std::size_t f = 0; f < all.Facets.size(); ++f)
  {
    Triangle corners = all.Facets[f];
    bool isShared = true;
    for (Id& p : corners)
    {
      isShared = isShared && joined[p].IsShared;
      p = joined[p].Number;
    }
    FacetSource place = { facets, false };
    if (isShared)
    {
      const SortedTriangle sorted(corners);
      const auto [found, isNew] = known.insert({ sorted.Points, { facets, sorted.Turned } });
      place = { found->second.Triangle, found->second.Reversed != sorted.Turned };
    }
    if (place.Triangle == facets)
    {
      all.Facets[facets] = corners;
      this->Known.SetOf[facets] = this->Known.SetOf[f];
      multiplicity.push_back(0);
      ++facets;
    }
    const int count = all.Multiplicity[f];
    multiplicity[place.Triangle] += place.Reversed ? -count : count;
    places.push_back(place);
  }
  all.Facets.resize(static_cast<std::size_t>(facets));
  this->Known.SetOf.resize(static_cast<std::size_t>(facets));
  SetMultiplicity(multiplicity, all);
  for (Id& f : this->Known.NearOthers)
  {
    f = places[f].Triangle;
  }
  SortUniquely(this->Known.NearOthers);
  return places;
}

/** The chains as one complex, whose sources are the chains' facets, numbered consecutively. */
FacetComplex BodyResolver::Together()
{
  FacetComplex together = this->ChainsInSequence();
  this->FindNearOthers(together);
  std::vector<FacetSource> places(together.Facets.size());
  for (Id f = 0; f < together.NumberOfFacets(); ++f)
  {
    places[f] = { f, false };
  }
  const std::vector<Id> lowest = this->LowestEqualPoints(together);
  if (!lowest.empty())
  {
    places = this->JoinFacets(lowest, together);
  }
  for (PointOrigin& origin : together.Origins)
  {
    for (Id& p : origin.Points)
    {
      p = this->SamePoints.Find(p);
    }
  }
  SetFacetSources(places, together);
  this->TakeOwnCrossings(places);
  this->TakeTouching(places);
  together.NumberOfConstraints = together.NumberOfFacets();
  return together;
}

/**
 * Convert the bodies' own crossings to facets of the joint complex.
 * @param[in] places of the chains' facets
 */
void BodyResolver::TakeOwnCrossings(const std::vector<FacetSource>& places)
{
  for (std::size_t b = 0; b < this->Chains.size(); ++b)
  {
    for (const auto& pair : this->OwnCrossings[b])
    {
      const Id i = places[this->FirstFacet[b] + pair[0]].Triangle;
      const Id j = places[this->FirstFacet[b] + pair[1]].Triangle;
      this->Known.Pairs.push_back({ std::min(i, j), std::max(i, j) });
    }
  }
}

/**
 * Convert touching facets to facets of the joint complex.
 * @param[in] places of the chains' facets
 */
void BodyResolver::TakeTouching(const std::vector<FacetSource>& places)
{
  std::vector<std::array<Id, 2>> pairs;
  for (const auto& [first, second] : this->Touching.Pairs)
  {
    const Id i = places[first].Triangle;
    const Id j = places[second].Triangle;
    if (i != j)
    {
      pairs.push_back({ std::min(i, j), std::max(i, j) });
    }
  }
  this->Touching.Pairs = std::move(pairs);
}

/**
 * Store the resolved complex, and translate its sources from facets of the chains to bodies and
 * their triangles.
 * @return the facets that may be near another body's
 */
std::vector<Id> BodyResolver::TakeResolved(FacetComplex resolved)
{
  std::vector<Id> near;
  std::vector<FacetSource> sources;
  std::vector<Id> offsets = { 0 };
  std::vector<BodyCount>& counts = this->Result.BodyCounts;
  sources.reserve(resolved.Sources.size());
  offsets.reserve(resolved.Facets.size() + 1);
  counts.reserve(resolved.Sources.size());
  this->Result.CountOffsets.reserve(resolved.Facets.size() + 1);
  for (Id f = 0; f < resolved.NumberOfFacets(); ++f)
  {
    const std::size_t firstSource = sources.size();
    const std::size_t firstCount = counts.size();
    bool isNear = false;
    for (Id s = resolved.SourceOffsets[f]; s < resolved.SourceOffsets[f + 1]; ++s)
    {
      const auto [facet, reversed] = resolved.Sources[s];
      isNear |= this->IsNear[facet] != 0;
      const Id body = this->BodyOf(facet);
      const FacetComplex& chain = this->Chains[body];
      const Id own = facet - this->FirstFacet[body];
      const int count = reversed ? -chain.Multiplicity[own] : chain.Multiplicity[own];
      if (counts.size() == firstCount || counts.back().Body != body)
      {
        counts.push_back({ body, 0 });
      }
      counts.back().Count += count;
      for (Id i = chain.SourceOffsets[own]; i < chain.SourceOffsets[own + 1]; ++i)
      {
        sources.push_back({ chain.Sources[i].Triangle, chain.Sources[i].Reversed != reversed });
      }
    }
    if (isNear)
    {
      near.push_back(f);
    }
    counts.erase(std::remove_if(counts.begin() + firstCount, counts.end(),
                   [](const BodyCount& count) { return count.Count == 0; }),
      counts.end());
    this->Result.CountOffsets.push_back(static_cast<Id>(counts.size()));
    if (sources.size() - firstSource > 1) // avoids an allocation per facet
    {
      std::stable_sort(sources.begin() + firstSource, sources.end(),
        [](const FacetSource& a, const FacetSource& b) { return a.Triangle < b.Triangle; });
    }
    offsets.push_back(static_cast<Id>(sources.size()));
  }
  resolved.Sources = std::move(sources);
  resolved.SourceOffsets = std::move(offsets);
  this->Result.Surface = std::move(resolved);
  return near;
}

std::vector<std::string> BodyResolver::Names() const
{
  std::vector<std::string> names;
  for (const Body& body : this->Given)
  {
    names.push_back(body.Name);
  }
  return names;
}

/** Uses coordinates as given: moved ones are on no grid. */
void BodyResolver::FindGrids()
{
  for (const Body& body : this->Given)
  {
    this->Grids.push_back(FindCoordinateGrid(body.Soup.Points));
  }
}

void BodyResolver::Touch()
{
  Touches touches = TouchBodies(
    this->Chains, this->Grids, this->Parameters.TouchTolerance, this->OwnCrossings, this->Watch);
  this->Touching = std::move(touches.Facets);
  this->Result.TouchingPairs = static_cast<Id>(touches.Bodies.size());
  for (const TouchingBodies& pair : touches.Bodies)
  {
    this->Result.TouchMovedPoints += pair.MovedPoints;
  }
  for (const std::string& line : WordsOf(touches.Bodies, this->Names()))
  {
    this->Result.Warnings.push_back(line);
  }
}

void BodyResolver::TellOfNearBodies(const std::vector<Id>& candidates)
{
  std::vector<NearBodies> near = FindNearBodies(this->Result, candidates, this->Watch);
  for (NearBodies& pair : near)
  {
    this->Result.NearTriangles += pair.Triangles;
    if (this->Grids[pair.First] && this->Grids[pair.Second])
    {
      const double size = LargestCoordinate(this->Result.Surface.Points);
      const double rounding =
        this->Grids[pair.First]->RoundingAt(size) + this->Grids[pair.Second]->RoundingAt(size);
      pair.Tolerance = std::max(pair.Tolerance, TouchToleranceOf(rounding));
    }
  }
  for (const std::string& line : WordsOf(near, this->Names(), this->Parameters.TouchTolerance))
  {
    this->Result.Warnings.push_back(line);
  }
}

Id BodyResolver::BodyOf(Id chainFacet) const
{
  // If several bodies begin at one facet, all except the last are empty.
  const auto next = std::upper_bound(this->FirstFacet.begin(), this->FirstFacet.end(), chainFacet);
  return static_cast<Id>(next - this->FirstFacet.begin()) - 1;
}

/** Resolve the only body: its chain is the whole complex. */
void BodyResolver::ResolveAlone()
{
  FacetComplex& chain = this->Chains[0];
  const KnownCrossings known = { std::vector<Id>(chain.Facets.size(), 0), {},
    this->OwnCrossings[0] };
  Resolution resolution = ResolveSelfIntersections(std::move(chain), this->Watch, known);
  this->Result.IntersectingPairs = static_cast<Id>(resolution.IntersectingPairs.size());
  this->Warn(this->Given[0], resolution.Warnings);
  this->Result.Surface = std::move(resolution.Surface);
  for (const std::int16_t count : this->Result.Surface.Multiplicity)
  {
    if (count != 0)
    {
      this->Result.BodyCounts.push_back({ 0, count });
    }
    this->Result.CountOffsets.push_back(static_cast<Id>(this->Result.BodyCounts.size()));
  }
}

void BodyResolver::ResolveTogether()
{
  FacetComplex together = this->Together();
  // Without a tolerance even the smallest overlap counts.
  const std::vector<Id> mayTouch =
    this->Parameters.Chain.MergeTolerance > 0 ? this->Known.NearOthers : std::vector<Id>();
  Resolution resolution = ResolveSelfIntersections(
    std::move(together), this->Watch, this->Known, this->Touching, mayTouch);
  this->Result.IntersectingPairs = static_cast<Id>(resolution.IntersectingPairs.size());
  const auto& warnings = resolution.Warnings;
  this->Result.Warnings.insert(this->Result.Warnings.end(), warnings.begin(), warnings.end());
  this->TellOfNearBodies(this->TakeResolved(std::move(resolution.Surface)));
}

ResolvedBodies BodyResolver::Resolve()
{
  Stopwatch stopwatch;
  const bool areSeveral = this->Given.size() > 1;
  const bool mayTouch = areSeveral && this->Parameters.TouchTolerance != 0;
  if (areSeveral)
  {
    this->FindGrids();
  }
  if (areSeveral && this->Parameters.Chain.MergeTolerance > 0)
  {
    this->MergeGivenPoints();
    const Id moved = CloseGaps(this->Given, this->Parameters.Chain.MergeTolerance, this->Watch);
    if (moved > 0)
    {
      this->Result.Warnings.push_back(std::to_string(moved) +
        (moved == 1 ? " point was" : " points were") +
        " moved into planes of other bodies, which were nearer than the merge tolerance");
    }
  }
  this->CountFacetsOfBodies();
  if (!this->Thickens())
  {
    this->FindOwnCrossings();
  }
  this->OrientBodies();
  if (mayTouch)
  {
    this->Touch();
  }
  this->Result.SecondsValidate = stopwatch.Lap();
  std::sort(this->Result.DegenerateTriangles.begin(), this->Result.DegenerateTriangles.end());
  std::sort(this->Result.TurnedTriangles.begin(), this->Result.TurnedTriangles.end());
  std::sort(this->Result.SheetTriangles.begin(), this->Result.SheetTriangles.end());
  areSeveral ? this->ResolveTogether() : this->ResolveAlone();
  this->Result.MergedInto.reserve(static_cast<std::size_t>(this->NumberOfIds));
  for (Id p = 0; p < this->NumberOfIds; ++p)
  {
    this->Result.MergedInto.push_back(this->SamePoints.Find(p));
  }
  return std::move(this->Result);
}
} // namespace

void AddTouches(const ResolvedBodies& bodies, Statistics& statistics)
{
  statistics.emplace_back("TouchingPairs", bodies.TouchingPairs);
  statistics.emplace_back("TouchMovedPoints", bodies.TouchMovedPoints);
  statistics.emplace_back("NearTriangles", bodies.NearTriangles);
}

ResolvedBodies ResolveBodies(
  std::vector<Body> bodies, const BodyParameters& parameters, Monitor& monitor)
{
  return BodyResolver(std::move(bodies), parameters, monitor).Resolve();
}
} // namespace insideout
