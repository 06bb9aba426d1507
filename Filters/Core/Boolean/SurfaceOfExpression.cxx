// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/SurfaceOfExpression.h"

#include "Common/Stages.h"
#include "Orient/PatchWindingNumbers.h"

#include <algorithm>

namespace insideout
{
namespace
{
/** Whether an expression holds just beside a patch: before and behind one of its facets. */
struct HoldsBeside
{
  bool Front;
  bool Back;
};

/** The facets that count for a body. */
std::vector<CountedTriangle> ChainOf(const ResolvedBodies& bodies, Id body)
{
  std::vector<CountedTriangle> chain;
  for (Id f = 0; f < bodies.Surface.NumberOfFacets(); ++f)
  {
    if (const int count = CountFor(bodies, f, body); count != 0)
    {
      chain.push_back({ bodies.Surface.Facets[f], count });
    }
  }
  return chain;
}

std::vector<HoldsBeside> HoldsBesidePatches(const ResolvedBodies& bodies, const PatchPlaces& places,
  Id numberOfPatches, const SetExpression& expression, Monitor& monitor)
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
    }
  }
  std::vector<HoldsBeside> holds;
  for (std::size_t patch = 0; patch < patches; ++patch)
  {
    holds.push_back({ expression.Holds(front[patch]), expression.Holds(back[patch]) });
  }
  return holds;
}

/** Whether two facets of a patch run the same way: what counts on one side of one does so there. */
bool RunAlike(const ResolvedBodies& bodies, Id a, Id b)
{
  return bodies.Counts[bodies.CountOffsets[a]].Count == bodies.Counts[bodies.CountOffsets[b]].Count;
}

/** Per facet +1 where it is on the surface and its normal points outward, -1 where inward, else 0.
 */
std::vector<signed char> SidesOfFacets(const ResolvedBodies& bodies, const SurfacePatches& patches,
  const PatchPlaces& places, const std::vector<HoldsBeside>& holds)
{
  std::vector<signed char> sides(bodies.Surface.Facets.size(), 0);
  for (Id f = 0; f < bodies.Surface.NumberOfFacets(); ++f)
  {
    const Id patch = patches.Patch[f];
    if (holds[patch].Front != holds[patch].Back)
    {
      sides[f] = holds[patch].Back == RunAlike(bodies, f, places.FacetOf(patch)) ? 1 : -1;
    }
  }
  return sides;
}

/** @throws Error Inconsistent where an edge is not run through as often one way as the other */
void CheckBalance(const std::vector<FacetEdge>& edges, const std::vector<signed char>& sides)
{
  ForEachEdge(edges,
    [&](const FacetEdge* first, const FacetEdge* last)
    {
      int sum = 0;
      for (const FacetEdge* edge = first; edge != last; ++edge)
      {
        sum += edge->Direction * sides[edge->Facet];
      }
      if (sum != 0)
      {
        throw Error(ErrorCode::Inconsistent,
          "the surface of the expression is open at the edge of points " +
            std::to_string(first->Low) + " and " + std::to_string(first->High));
      }
    });
}
} // namespace

std::optional<std::vector<BoundaryTriangle>> SurfaceOfExpression(
  const ResolvedBodies& bodies, const SetExpression& expression, Monitor& monitor)
{
  const FacetComplex& surface = bodies.Surface;
  const std::vector<FacetEdge> edges = SortedFacetEdges(surface.Facets);
  const std::vector<char> isClosed = FindClosedBodies(bodies, edges);
  if (surface.NumberOfConstraints < surface.NumberOfFacets() ||
    std::find(isClosed.begin(), isClosed.end(), 0) != isClosed.end())
  {
    return std::nullopt;
  }
  const SurfacePatches patches = FindPatches(surface, edges);
  const PatchPlaces places(surface, patches);
  const std::vector<HoldsBeside> holds =
    HoldsBesidePatches(bodies, places, patches.Count, expression, monitor);
  const std::vector<signed char> sides = SidesOfFacets(bodies, patches, places, holds);
  CheckBalance(edges, sides);

  std::vector<BoundaryTriangle> triangles;
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    if (sides[f] != 0)
    {
      const auto [a, b, c] = surface.Facets[f];
      triangles.push_back({ sides[f] > 0 ? Triangle{ { a, b, c } } : Triangle{ { a, c, b } },
        SourceOfFacet(surface, f, sides[f]) });
    }
  }
  monitor.Check(Stages::Extracting, 1);
  return triangles;
}
} // namespace insideout
