// SPDX-License-Identifier: GPL-3.0-or-later
#include "ResolveSelfIntersections.h"

#include "CutFacets.h"
#include "FindIntersections.h"
#include "Interpolation.h"
#include "PointIndex.h"
#include "TrianglePredicates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

namespace insideout
{
namespace
{
constexpr const char* Stage = "resolving self-intersections";

/** Rounds after which what still crosses is left out. Most real models take one to three. */
constexpr int MaximumRounds = 30;

/** Rounds without fewer crossings than ever before, after which no more are tried. */
constexpr int Patience = 6;

/** Where crossings become this many times more than they once were, cutting makes things worse:
 * facets in nearly one plane, that cross along ever more lines. */
constexpr std::size_t Divergence = 4;

/**
 * How far new points move at most to an existing point, relative to the largest coordinate: in the
 * first round not at all; then some spacings of the doubles, because new points nearer than that to
 * old ones make slivers that cross again. Over all rounds the sum stays below 1e-12.
 */
double SnappingRadius(int round, double largestCoordinate)
{
  return round == 1 ? 0 : std::ldexp(largestCoordinate, -45);
}

using Pairs = std::vector<std::array<Id, 2>>;

/** What a facet stands for, beside its corners. */
struct Meaning
{
  Id Root = None;       ///< a facet of the given complex that it is a piece of
  int Multiplicity = 0; ///< along its own orientation
  std::vector<FacetSource> Sources;
};

Meaning MeaningOf(const FacetComplex& surface, Id facet)
{
  const auto sources = surface.Sources.begin();
  return { facet, surface.Multiplicity[facet],
    { sources + surface.SourceOffsets[facet], sources + surface.SourceOffsets[facet + 1] } };
}

/** Adds the sources and multiplicity of a coinciding facet, or of the reverse of one. */
void Add(Meaning& meaning, const Meaning& other, bool reversed)
{
  meaning.Multiplicity += reversed ? -other.Multiplicity : other.Multiplicity;
  for (const FacetSource& source : other.Sources)
  {
    const auto place = std::lower_bound(meaning.Sources.begin(), meaning.Sources.end(), source,
      [](const FacetSource& a, const FacetSource& b) { return a.Triangle < b.Triangle; });
    if (place == meaning.Sources.end() || place->Triangle != source.Triangle)
    {
      meaning.Sources.insert(place, { source.Triangle, source.Reversed != reversed });
    }
  }
}

Triangle Sorted(Triangle triangle)
{
  std::sort(triangle.begin(), triangle.end());
  return triangle;
}

/** Whether two triangles with the same corners run opposite ways. */
bool AreOpposite(const Triangle& a, const Triangle& b)
{
  const auto first = std::find(b.begin(), b.end(), a[0]) - b.begin();
  return a[1] != b[(first + 1) % 3];
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
  std::vector<PointOrigin> Origins;
  std::vector<Triangle> Facets;
  std::vector<Meaning> Meanings; ///< one per facet
  Pairs Crossings;               ///< pairs of facets that cross
};

class Resolver
{
public:
  Resolver(const FacetComplex& surface, Monitor& monitor);
  Resolution Resolve();

private:
  void CutRepeatedly();
  Id Cut();
  void PreparePoints();
  std::vector<CutFacet> TakePieces(const PlanarSubdivision& subdivision);
  std::vector<Id> PlacePoints(const PlanarSubdivision& subdivision);
  Id PlacePoint(const Point& p, Id root);
  PointOrigin OriginOf(const Point& p, Id root) const;
  Id KeepUncut();
  void AddFacets(std::vector<CutFacet> facets);
  FacetComplex Assemble(const std::vector<Id>& leftOut) const;

  const FacetComplex& Surface;
  Monitor& Watch;
  const double Size; ///< the largest coordinate
  int Round = 0;

  State Now;

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
  this->Now.Origins = surface.Origins;
  this->Now.Facets.assign(
    surface.Facets.begin(), surface.Facets.begin() + surface.NumberOfConstraints);
  for (Id f = 0; f < surface.NumberOfConstraints; ++f)
  {
    this->Now.Meanings.push_back(MeaningOf(surface, f));
  }
}

Resolution Resolver::Resolve()
{
  this->Now.Crossings = FindIntersections(this->Now.Points, this->Now.Facets, this->Watch);
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
    const Id firstNew = this->Cut();
    this->Now.Crossings =
      FindIntersections(this->Now.Points, this->Now.Facets, firstNew, this->Watch);
    const std::size_t count = this->Now.Crossings.size();
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

/**
 * Cuts the facets that cross. Afterwards the uncut facets come first.
 * @return the first new facet
 */
Id Resolver::Cut()
{
  // How many rounds there will be is unknown: each takes half of the progress that is left.
  const double begin = 1 - std::ldexp(1.0, 1 - this->Round);
  const double end = 1 - std::ldexp(1.0, -this->Round);
  this->Watch.Check(Stage, begin);
  const std::vector<PlanarSubdivision> subdivisions = CutFacets(
    this->Now.Points, this->Now.Facets, this->Now.Crossings, this->Watch, { Stage, begin, end });

  this->PreparePoints();
  std::vector<CutFacet> pieces;
  for (const PlanarSubdivision& subdivision : subdivisions)
  {
    std::vector<CutFacet> taken = this->TakePieces(subdivision);
    std::move(taken.begin(), taken.end(), std::back_inserter(pieces));
  }
  this->Watch.Check(Stage, end);
  const Id firstNew = this->KeepUncut();
  this->AddFacets(std::move(pieces));
  return firstNew;
}

void Resolver::PreparePoints()
{
  this->Moved = PointIndex(0);
  this->Nearby = PointIndex(SnappingRadius(this->Round, this->Size));
  std::vector<char> added(this->Now.Points.size(), 0);
  for (const auto& pair : this->Now.Crossings)
  {
    for (const Id f : pair)
    {
      for (const Id p : this->Now.Facets[f])
      {
        if (!added[p])
        {
          this->Nearby.Add(this->Now.Points[p], p);
          added[p] = 1;
        }
      }
    }
  }
}

/** The pieces with their points placed; those that rounding made degenerate are dropped. */
std::vector<CutFacet> Resolver::TakePieces(const PlanarSubdivision& subdivision)
{
  const std::vector<Id> ids = this->PlacePoints(subdivision);
  std::vector<CutFacet> facets;
  for (const Piece& piece : subdivision.Pieces)
  {
    const Triangle corners = { ids[piece.Corners[0]], ids[piece.Corners[1]],
      ids[piece.Corners[2]] };
    if (IsDegenerate(
          this->Now.Points[corners[0]], this->Now.Points[corners[1]], this->Now.Points[corners[2]]))
    {
      continue;
    }
    CutFacet facet{ corners, {} };
    facet.Means.Root = this->Now.Meanings[piece.Sources[0].Facet].Root;
    for (const PieceSource& source : piece.Sources)
    {
      Add(facet.Means, this->Now.Meanings[source.Facet], source.Reversed);
    }
    facets.push_back(std::move(facet));
  }
  return facets;
}

std::vector<Id> Resolver::PlacePoints(const PlanarSubdivision& subdivision)
{
  std::vector<Id> ids(subdivision.Points.size(), None);
  for (const Piece& piece : subdivision.Pieces)
  {
    for (const Id p : piece.Corners)
    {
      if (ids[p] == None)
      {
        const Id root = this->Now.Meanings[piece.Sources[0].Facet].Root;
        ids[p] = this->PlacePoint(subdivision.Points[p], root);
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
  this->Now.Origins.push_back(this->OriginOf(p, root));
  this->Positions.Add(p, id);
  this->Nearby.Add(p, id);
  return id;
}

PointOrigin Resolver::OriginOf(const Point& p, Id root) const
{
  const Triangle& corners = this->Surface.Facets[root];
  PointOrigin origin;
  std::array<Point, 3> triangle;
  for (int k = 0; k < 3; ++k)
  {
    origin.Points[k] = this->Surface.Origins[corners[k]].Points[0];
    triangle[k] = this->Surface.Points[corners[k]];
  }
  origin.Weights = BarycentricWeights(triangle, p);
  return origin;
}

/** Removes the facets that cross; returns how many are left. */
Id Resolver::KeepUncut()
{
  std::vector<char> isCut(this->Now.Facets.size(), 0);
  for (const auto& pair : this->Now.Crossings)
  {
    isCut[pair[0]] = isCut[pair[1]] = 1;
  }
  std::size_t kept = 0;
  for (std::size_t f = 0; f < this->Now.Facets.size(); ++f)
  {
    if (!isCut[f])
    {
      if (kept != f)
      {
        this->Now.Facets[kept] = this->Now.Facets[f];
        this->Now.Meanings[kept] = std::move(this->Now.Meanings[f]);
      }
      ++kept;
    }
  }
  this->Now.Facets.resize(kept);
  this->Now.Meanings.resize(kept);
  return static_cast<Id>(kept);
}

/** Adds facets, or what they mean to the ones with the same corners. */
void Resolver::AddFacets(std::vector<CutFacet> facets)
{
  std::vector<char> touched(this->Now.Points.size(), 0);
  for (const CutFacet& facet : facets)
  {
    touched[facet.Corners[0]] = touched[facet.Corners[1]] = touched[facet.Corners[2]] = 1;
  }
  std::map<Triangle, Id> ids;
  for (Id f = 0; f < static_cast<Id>(this->Now.Facets.size()); ++f)
  {
    const Triangle& corners = this->Now.Facets[f];
    if (touched[corners[0]] && touched[corners[1]] && touched[corners[2]])
    {
      ids.insert({ Sorted(corners), f });
    }
  }
  for (CutFacet& facet : facets)
  {
    const Id next = static_cast<Id>(this->Now.Facets.size());
    const auto inserted = ids.insert({ Sorted(facet.Corners), next });
    if (inserted.second)
    {
      this->Now.Facets.push_back(facet.Corners);
      this->Now.Meanings.push_back(std::move(facet.Means));
      continue;
    }
    const Id same = inserted.first->second;
    Add(this->Now.Meanings[same], facet.Means, AreOpposite(this->Now.Facets[same], facet.Corners));
  }
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

/** The constraints, then what is left out of them, then what the given complex had left out. */
FacetComplex Resolver::Assemble(const std::vector<Id>& leftOut) const
{
  FacetComplex surface;
  surface.Points = this->Now.Points;
  surface.Origins = this->Now.Origins;
  auto next = leftOut.begin();
  for (Id f = 0; f < static_cast<Id>(this->Now.Facets.size()); ++f)
  {
    if (next != leftOut.end() && *next == f)
    {
      ++next;
      continue;
    }
    Append(surface, this->Now.Facets[f], this->Now.Meanings[f]);
  }
  surface.NumberOfConstraints = surface.NumberOfFacets();
  for (const Id f : leftOut)
  {
    Append(surface, this->Now.Facets[f], this->Now.Meanings[f]);
  }
  for (Id f = this->Surface.NumberOfConstraints; f < this->Surface.NumberOfFacets(); ++f)
  {
    Append(surface, this->Surface.Facets[f], MeaningOf(this->Surface, f));
  }
  return surface;
}
} // namespace

Resolution ResolveSelfIntersections(const FacetComplex& surface, Monitor& monitor)
{
  return Resolver(surface, monitor).Resolve();
}
} // namespace insideout
