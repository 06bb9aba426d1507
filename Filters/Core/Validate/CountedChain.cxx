// SPDX-License-Identifier: GPL-3.0-or-later
#include "Validate/CountedChain.h"

#include "Common/Box.h"
#include "Common/Buckets.h"
#include "Common/ParallelLoop.h"
#include "Common/PointPredicates.h"
#include "Common/SortedTriangle.h"
#include "Common/Stages.h"
#include "Common/Vectors.h"
#include "Validate/CountCopies.h"
#include "Validate/FacetEdges.h"
#include "Validate/FacetSources.h"
#include "Validate/GivenSurfaces.h"
#include "Validate/MergePoints.h"
#include "Validate/TwoSidedComponents.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace insideout
{
namespace
{
void CheckTriangles(const TriangleSoup& soup)
{
  if (soup.Triangles.empty())
  {
    throw Error(ErrorCode::EmptySurface, "the surface has no polygons");
  }
  if (!soup.Multiplicity.empty() && soup.Multiplicity.size() != soup.Triangles.size())
  {
    throw Error(ErrorCode::InvalidParameter,
      std::to_string(soup.Multiplicity.size()) + " multiplicities are given for " +
        std::to_string(soup.Triangles.size()) + " triangles");
  }
  if (!soup.NonParticipating.empty() && soup.NonParticipating.size() != soup.Triangles.size())
  {
    throw Error(ErrorCode::InvalidParameter,
      "whether they participate is given for " + std::to_string(soup.NonParticipating.size()) +
        " of " + std::to_string(soup.Triangles.size()) + " triangles");
  }
  const Id numberOfPoints = static_cast<Id>(soup.Points.size());
  for (std::size_t t = 0; t < soup.Triangles.size(); ++t)
  {
    for (const Id p : soup.Triangles[t])
    {
      if (p < 0 || p >= numberOfPoints)
      {
        throw Error(ErrorCode::PointOutOfRange,
          "triangle " + std::to_string(t) + " refers to point " + std::to_string(p) + " of " +
            std::to_string(numberOfPoints));
      }
      if (!IsFinite(soup.Points[p]))
      {
        throw Error(ErrorCode::PointNotFinite, "point " + std::to_string(p) + " is not finite");
      }
    }
  }
}

bool Participates(const TriangleSoup& soup, Id triangle)
{
  return soup.NonParticipating.empty() || soup.NonParticipating[triangle] == 0;
}

/** Per triangle the first one with the same corners, itself included; None for degenerate ones. */
template <class CornersOf>
std::vector<Id> FirstWithSameCorners(const TriangleSoup& soup, const CornersOf& cornersOf)
{
  struct Entry
  {
    Id Middle;
    Id Highest;
    Id Triangle;
  };
  const double nanosecondsPerTriangle = 30;
  std::vector<Id> first(soup.Triangles.size(), None);
  ParallelLoop(first.size(), nanosecondsPerTriangle,
    [&](std::size_t t)
    {
      if (!IsDegenerate(soup.Points, cornersOf(t)))
      {
        first[t] = static_cast<Id>(t);
      }
    });
  Buckets<Entry> byLowest =
    Buckets<Entry>::Unordered(soup.Points.size(), first.size(), nanosecondsPerTriangle / 3,
      [&](std::size_t t, const auto& visit)
      {
        if (first[t] != None)
        {
          const Triangle corners = SortedTriangle(cornersOf(t)).Points;
          visit(static_cast<std::size_t>(corners[0]),
            Entry{ corners[1], corners[2], static_cast<Id>(t) });
        }
      });
  ParallelLoop(byLowest.Size(), nanosecondsPerTriangle,
    [&](std::size_t lowest)
    {
      byLowest.Sort(lowest,
        [](const Entry& a, const Entry& b) {
          return std::tie(a.Middle, a.Highest, a.Triangle) <
            std::tie(b.Middle, b.Highest, b.Triangle);
        });
      Entry leader = { None, None, None };
      for (const Entry& entry : byLowest[lowest])
      {
        const bool isSame = entry.Middle == leader.Middle && entry.Highest == leader.Highest;
        leader = isSame ? leader : entry;
        first[entry.Triangle] = leader.Triangle;
      }
    });
  return first;
}

/** One facet per set of three corners, in the order of their first triangles, with its sources. */
void CollectFacets(const TriangleSoup& soup, const std::vector<Id>& merged, CountedChain& chain)
{
  FacetComplex& surface = chain.Surface;
  const auto cornersOf = [&](std::size_t t)
  {
    const Triangle& given = soup.Triangles[t];
    return Triangle{ { merged[given[0]], merged[given[1]], merged[given[2]] } };
  };
  const std::vector<Id> first = FirstWithSameCorners(soup, cornersOf);
  const auto isTurned = [&](Id t) { return SortedTriangle(cornersOf(t)).Turned; };
  std::vector<FacetSource> places; // per triangle its facet, None for degenerate ones
  surface.Facets.reserve(soup.Triangles.size());
  places.reserve(soup.Triangles.size());
  for (Id t = 0; t < static_cast<Id>(soup.Triangles.size()); ++t)
  {
    if (first[t] == None)
    {
      chain.DegenerateTriangles.push_back(t);
      places.push_back({ None, false });
      continue;
    }
    if (first[t] == t)
    {
      places.push_back({ surface.NumberOfFacets(), false });
      surface.Facets.push_back(cornersOf(t));
      continue;
    }
    places.push_back({ places[first[t]].Triangle, isTurned(t) != isTurned(first[t]) });
  }
  SetFacetSources(places, surface);
  surface.NumberOfConstraints = surface.NumberOfFacets();
}

/**
 * The number of copies of each facet from participating triangles, and the number of these facets.
 */
struct GivenFacets
{
  std::vector<FacetCopies> Copies;
  std::vector<Id> Participants;
};

GivenFacets FacetsAsGiven(const TriangleSoup& soup, const FacetComplex& surface)
{
  GivenFacets given;
  given.Copies.resize(surface.Facets.size());
  given.Participants.resize(surface.Facets.size(), 0);
  for (std::size_t f = 0; f < surface.Facets.size(); ++f)
  {
    for (Id s = surface.SourceOffsets[f]; s < surface.SourceOffsets[f + 1]; ++s)
    {
      const auto [triangle, reversed] = surface.Sources[s];
      if (Participates(soup, triangle))
      {
        FacetCopies& copies = given.Copies[f];
        (reversed ? copies.Against : copies.Along) +=
          soup.Multiplicity.empty() ? 1 : soup.Multiplicity[triangle];
        ++given.Participants[f];
      }
    }
  }
  return given;
}

/** The count of each facet, by its sources. */
void CountSources(const TriangleSoup& soup, bool countDuplicates, CountedChain& chain)
{
  FacetComplex& surface = chain.Surface;
  SurfaceCounts& counts = chain.Counts;
  counts.DegenerateFacets = static_cast<Id>(chain.DegenerateTriangles.size());
  if (surface.Sources.size() == surface.Facets.size() && soup.Multiplicity.empty() &&
    soup.NonParticipating.empty())
  {
    surface.Multiplicity.assign(surface.Facets.size(), 1); // each is given once
    surface.Opposed.assign(surface.Facets.size(), 0);
    return;
  }
  const GivenFacets given = FacetsAsGiven(soup, surface);
  const bool chooses = soup.Multiplicity.empty() && !countDuplicates;
  const std::vector<FacetCopies> counted =
    chooses ? CountCopies(surface, chain.Edges, given.Copies) : given.Copies;
  surface.Multiplicity.reserve(surface.Facets.size());
  surface.Opposed.assign(surface.Facets.size(), 0);
  for (std::size_t f = 0; f < surface.Facets.size(); ++f)
  {
    const Id first = surface.SourceOffsets[f];
    const Id copies = surface.SourceOffsets[f + 1] - first;
    const std::int64_t multiplicity = counted[f].Along - counted[f].Against;
    constexpr std::int64_t most = std::numeric_limits<std::int16_t>::max();
    if (std::abs(multiplicity) > most)
    {
      throw Error(ErrorCode::TooLarge,
        "triangle " + std::to_string(surface.Sources[first].Triangle) + " is given " +
          std::to_string(copies) + " times, more than can be counted");
    }
    surface.Multiplicity.push_back(static_cast<std::int16_t>(multiplicity));
    counts.DuplicateFacets += copies - 1;
    counts.CancelledFacets += given.Participants[f] > 1 && multiplicity == 0;
    counts.NonParticipatingFacets += given.Participants[f] == 0;
    if (chooses)
    {
      surface.Opposed[f] =
        static_cast<std::int16_t>(std::min({ counted[f].Along, counted[f].Against, most }));
      counts.SharedFacets += static_cast<Id>(
        counted[f].Along - (counted[f].Along > 0) + counted[f].Against - (counted[f].Against > 0));
    }
  }
}

/** Keep the points that facets use, in the input's order. */
void CompactPoints(const std::vector<Point>& points, const std::vector<Id>& merged,
  FacetComplex& surface, SurfaceCounts& counts)
{
  std::vector<Id> index(points.size(), None);
  for (const Triangle& facet : surface.Facets)
  {
    for (const Id p : facet)
    {
      index[p] = 0;
    }
  }
  surface.Points.reserve(points.size());
  surface.Origins.reserve(points.size());
  for (Id p = 0; p < static_cast<Id>(points.size()); ++p)
  {
    counts.MergedPoints += merged[p] != p;
    if (index[p] != None)
    {
      index[p] = static_cast<Id>(surface.Points.size());
      surface.Points.push_back(points[p]);
      surface.Origins.push_back(PointOrigin::Input(p));
    }
  }
  for (Triangle& facet : surface.Facets)
  {
    for (Id& p : facet)
    {
      p = index[p];
    }
  }
}

/** The facets that contain a participating input triangle. */
std::vector<Id> ParticipatingFacets(const TriangleSoup& soup, const FacetComplex& surface)
{
  std::vector<Id> facets;
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    const auto begin = surface.Sources.begin();
    if (std::any_of(begin + surface.SourceOffsets[f], begin + surface.SourceOffsets[f + 1],
          [&](const FacetSource& source) { return Participates(soup, source.Triangle); }))
    {
      facets.push_back(f);
    }
  }
  return facets;
}

/** Apply the rule of two-sided components to some facets, independently of the others. */
TwoSidedComponents KeepTwoSidedSolidsAmong(const std::vector<Id>& facets, FacetComplex& surface)
{
  FacetComplex part;
  part.Points = surface.Points;
  for (const Id f : facets)
  {
    part.Facets.push_back(surface.Facets[f]);
    part.Multiplicity.push_back(surface.Multiplicity[f]);
    part.Opposed.push_back(surface.Opposed[f]);
  }
  const FacetEdges edges = SortedFacetEdges(part.Facets);
  const TwoSidedComponents twoSided =
    KeepTwoSidedSolids(part, edges, ComponentsOfFacets(part.NumberOfFacets(), edges));
  for (std::size_t i = 0; i < facets.size(); ++i)
  {
    surface.Multiplicity[facets[i]] = part.Multiplicity[i];
    surface.Opposed[facets[i]] = part.Opposed[i];
  }
  return twoSided;
}

void CountEdges(const std::vector<Point>& points, const FacetEdges& edges, SurfaceCounts& counts)
{
  ForEachEdge(edges,
    [&](const FacetEdge* first, const FacetEdge* last)
    {
      if (last - first == 1)
      {
        ++counts.OpenEdges;
        counts.OpenLength += Distance(points[first->Low], points[first->High]);
      }
      counts.NonManifoldEdges += last - first > 2;
    });
}

std::vector<std::string> WarningsAbout(const SurfaceCounts& counts)
{
  std::vector<std::string> warnings;
  if (counts.DegenerateFacets > 0)
  {
    warnings.push_back(
      std::to_string(counts.DegenerateFacets) + " degenerate facets (without area) are left out");
  }
  if (counts.TwoSidedSolids > 0)
  {
    warnings.push_back(std::to_string(counts.TwoSidedSolids) +
      " two-sided components that enclose a volume are kept once, turned outward");
  }
  if (counts.TwoSidedSheets > 0)
  {
    warnings.push_back(std::to_string(counts.TwoSidedSheets) +
      " two-sided sheets enclose no volume: they shape the mesh, but do not count");
  }
  return warnings;
}
} // namespace

CountedChain CountFacets(
  const TriangleSoup& soup, const CountedChainParameters& parameters, Monitor& monitor)
{
  if (!(parameters.MergeTolerance >= 0) || std::isinf(parameters.MergeTolerance))
  {
    throw Error(ErrorCode::InvalidParameter, "MergeTolerance must be finite and at least 0");
  }
  CheckTriangles(soup);
  CountedChain chain;
  chain.Counts.InputPoints = static_cast<Id>(soup.Points.size());
  chain.Counts.InputTriangles = static_cast<Id>(soup.Triangles.size());

  monitor.Check(Stages::Validating, 0.1);
  chain.MergedInto = MergePoints(soup.Points, parameters.MergeTolerance);
  const std::vector<Id>& merged = chain.MergedInto;

  monitor.Check(Stages::Validating, 0.4);
  CollectFacets(soup, merged, chain);
  if (chain.Surface.Facets.empty())
  {
    throw Error(ErrorCode::AllDegenerate,
      "all " + std::to_string(soup.Triangles.size()) + " triangles are degenerate (without area)");
  }
  CompactPoints(soup.Points, merged, chain.Surface, chain.Counts);
  chain.Counts.Points = static_cast<Id>(chain.Surface.Points.size());
  chain.Counts.Facets = chain.Surface.NumberOfFacets();

  monitor.Check(Stages::Validating, 0.7);
  chain.Edges = SortedFacetEdges(chain.Surface.Facets);
  CountSources(soup, parameters.CountDuplicates, chain);
  const FacetEdges& edges = chain.Edges;
  const FacetComponents components = ComponentsOfFacets(chain.Counts.Facets, edges);
  chain.Counts.Components = components.Count;
  CountEdges(chain.Surface.Points, edges, chain.Counts);
  if (chain.Counts.NonManifoldEdges > 0)
  {
    chain.Surface.SourceSurfaces = FindGivenSurfaces(soup, chain.Surface, edges);
  }
  const Box box = BoundingBox(chain.Surface.Points);
  chain.Counts.Diagonal = Distance(box.Low, box.High);
  if (soup.Multiplicity.empty())
  {
    const TwoSidedComponents twoSided = chain.Counts.NonParticipatingFacets == 0
      ? KeepTwoSidedSolids(chain.Surface, edges, components)
      : KeepTwoSidedSolidsAmong(ParticipatingFacets(soup, chain.Surface), chain.Surface);
    chain.Counts.TwoSidedSolids = twoSided.Solids;
    chain.Counts.TwoSidedSheets = twoSided.Sheets;
  }
  chain.Warnings = WarningsAbout(chain.Counts);
  chain.Coordinates = FindCoarseCoordinates(chain.Surface.Points, edges);
  if (chain.Coordinates.AreTooCoarse())
  {
    chain.Warnings.push_back(WarningAbout(chain.Coordinates));
  }
  monitor.Check(Stages::Validating, 1);
  return chain;
}

void AddCounts(const SurfaceCounts& counts, Statistics& statistics)
{
  statistics.emplace_back("InputPoints", counts.InputPoints);
  statistics.emplace_back("InputTriangles", counts.InputTriangles);
  statistics.emplace_back("Points", counts.Points);
  statistics.emplace_back("Facets", counts.Facets);
  statistics.emplace_back("OpenEdges", counts.OpenEdges);
  statistics.emplace_back("OpenLength", counts.OpenLength);
  statistics.emplace_back("Diagonal", counts.Diagonal);
  statistics.emplace_back("NonManifoldEdges", counts.NonManifoldEdges);
  statistics.emplace_back("Components", counts.Components);
  statistics.emplace_back("MergedPoints", counts.MergedPoints);
  statistics.emplace_back("DegenerateFacets", counts.DegenerateFacets);
  statistics.emplace_back("DuplicateFacets", counts.DuplicateFacets);
  statistics.emplace_back("SharedFacets", counts.SharedFacets);
  statistics.emplace_back("CancelledFacets", counts.CancelledFacets);
  statistics.emplace_back("TwoSidedSolids", counts.TwoSidedSolids);
  statistics.emplace_back("TwoSidedSheets", counts.TwoSidedSheets);
  statistics.emplace_back("NonParticipatingFacets", counts.NonParticipatingFacets);
}
} // namespace insideout
