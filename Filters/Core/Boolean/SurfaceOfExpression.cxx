// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/SurfaceOfExpression.h"

#include "Boolean/PatchBoundary.h"
#include "Boolean/SingleBodies.h"
#include "Common/Stages.h"

#include <algorithm>

namespace insideout
{
namespace
{
/** The facets that count for a body. */
std::vector<CountedTriangle> ChainOf(const ResolvedBodies& bodies, Id body)
{
  std::vector<CountedTriangle> chain;
  chain.reserve(bodies.Surface.Facets.size());
  for (Id f = 0; f < bodies.Surface.NumberOfFacets(); ++f)
  {
    if (const int count = CountFor(bodies, f, body); count != 0)
    {
      chain.push_back({ bodies.Surface.Facets[f], count });
    }
  }
  return chain;
}

/** @param[out] surface gains the range of w */
std::vector<HoldsBeside> HoldsBesidePatches(const ResolvedBodies& bodies, const PatchPlaces& places,
  Id numberOfPatches, const SetExpression& expression, ExpressionSurface& surface, Monitor& monitor)
{
  const std::size_t patches = static_cast<std::size_t>(numberOfPatches);
  const std::size_t numberOfBodies = bodies.Bodies.size();
  std::vector<std::vector<char>> front(patches, std::vector<char>(numberOfBodies));
  std::vector<std::vector<char>> back = front;
  for (Id body = 0; body < bodies.NumberOfBodies(); ++body)
  {
    std::vector<int> counts;
    for (Id patch = 0; patch < numberOfPatches; ++patch)
    {
      counts.push_back(CountFor(bodies, places.FacetOf(patch), body));
    }
    const ProgressRange whole = { Stages::WindingNumbers, 0, 1 };
    const double n = static_cast<double>(numberOfBodies);
    const std::vector<PatchSides> sides = places.WindingNumbers(ChainOf(bodies, body), counts,
      monitor, { Stages::WindingNumbers, whole.At(body / n), whole.At((body + 1) / n) });
    for (std::size_t patch = 0; patch < patches; ++patch)
    {
      front[patch][body] = sides[patch].Front >= 1;
      back[patch][body] = sides[patch].Back >= 1;
      surface.MinimumW = std::min({ surface.MinimumW, sides[patch].Front, sides[patch].Back });
      surface.MaximumW = std::max({ surface.MaximumW, sides[patch].Front, sides[patch].Back });
    }
  }
  std::vector<HoldsBeside> holds;
  for (std::size_t patch = 0; patch < patches; ++patch)
  {
    holds.push_back({ expression.Holds(front[patch]), expression.Holds(back[patch]) });
  }
  return holds;
}

/** Per facet, its count for the first body that it counts for. */
std::vector<int> FirstCounts(const ResolvedBodies& bodies)
{
  std::vector<int> counts;
  counts.reserve(bodies.Surface.Facets.size());
  for (Id f = 0; f < bodies.Surface.NumberOfFacets(); ++f)
  {
    const Id first = bodies.CountOffsets[f];
    counts.push_back(first < bodies.CountOffsets[f + 1] ? bodies.BodyCounts[first].Count : 0);
  }
  return counts;
}

std::vector<OutlierPiece> OutliersOf(
  const FacetComplex& surface, const SurfacePatches& patches, const std::vector<HoldsBeside>& holds)
{
  std::vector<OutlierPiece> outliers;
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    const HoldsBeside& sides = holds[patches.Patch[f]];
    if (!sides.Front && !sides.Back)
    {
      outliers.push_back({ surface.Facets[f], f, OutlierReason::Energy });
    }
  }
  return outliers;
}
} // namespace

std::optional<ExpressionSurface> SurfaceOfExpression(
  const ResolvedBodies& bodies, const SetExpression& expression, Monitor& monitor)
{
  const FacetComplex& surface = bodies.Surface;
  const FacetEdges edges = SortedFacetEdges(surface.Facets);
  if (surface.NumberOfConstraints < surface.NumberOfFacets() || !AreClosed(bodies, edges))
  {
    return std::nullopt;
  }
  const SurfacePatches patches = FindPatches(surface, edges);
  const PatchPlaces places(surface, patches);
  ExpressionSurface found;
  const std::vector<HoldsBeside> holds =
    HoldsBesidePatches(bodies, places, patches.Count, expression, found, monitor);
  found.Boundary = PatchBoundary(surface, edges, patches, places, holds, FirstCounts(bodies));
  found.Outliers = OutliersOf(surface, patches, holds);
  monitor.Check(Stages::Extracting, 1);
  return found;
}
} // namespace insideout
