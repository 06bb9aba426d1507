// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/SingleBodies.h"

#include "Common/ParallelLoop.h"

#include <algorithm>

namespace insideout
{
namespace
{
/** What a thread looks at at once: some tenths of a millisecond. */
constexpr std::size_t EdgesPerBlock = 1 << 14;

/** Marks the bodies as open whose counts at edges that begin in a block do not sum to 0. */
void MarkOpenBodies(const ResolvedBodies& bodies, const std::vector<FacetEdge>& edges,
  std::size_t block, std::vector<char>& isOpen)
{
  const auto goesOn = [&](std::size_t i)
  { return edges[i].Low == edges[i - 1].Low && edges[i].High == edges[i - 1].High; };
  std::vector<int> sums(bodies.Bodies.size(), 0);
  const auto forCounts = [&](std::size_t edge, const auto& visit)
  {
    const Id facet = edges[edge].Facet;
    for (Id i = bodies.CountOffsets[facet]; i < bodies.CountOffsets[facet + 1]; ++i)
    {
      visit(bodies.BodyCounts[i].Body, edges[edge].Direction * bodies.BodyCounts[i].Count);
    }
  };
  const std::size_t end = std::min(edges.size(), (block + 1) * EdgesPerBlock);
  for (std::size_t first = block * EdgesPerBlock; first < end;)
  {
    std::size_t last = first + 1;
    for (; last < edges.size() && goesOn(last); ++last)
    {
    }
    const bool isOfBlockBefore = first > 0 && goesOn(first);
    for (std::size_t edge = first; !isOfBlockBefore && edge < last; ++edge)
    {
      forCounts(edge, [&](Id body, int count) { sums[body] += count; });
    }
    for (std::size_t edge = first; !isOfBlockBefore && edge < last; ++edge)
    {
      forCounts(edge,
        [&](Id body, int)
        {
          isOpen[body] |= sums[body] != 0;
          sums[body] = 0;
        });
    }
    first = last;
  }
}
} // namespace

std::vector<char> FindClosedBodies(
  const ResolvedBodies& bodies, const std::vector<FacetEdge>& edges)
{
  const std::size_t blocks = (edges.size() + EdgesPerBlock - 1) / EdgesPerBlock;
  std::vector<std::vector<char>> isOpen(blocks, std::vector<char>(bodies.Bodies.size(), 0));
  const double nanosecondsPerEdge = 10;
  ParallelLoop(blocks, nanosecondsPerEdge * EdgesPerBlock,
    [&](std::size_t block) { MarkOpenBodies(bodies, edges, block, isOpen[block]); });
  std::vector<char> isClosed(bodies.Bodies.size(), 1);
  for (const std::vector<char>& open : isOpen)
  {
    for (std::size_t body = 0; body < isClosed.size(); ++body)
    {
      isClosed[body] &= open[body] == 0;
    }
  }
  return isClosed;
}

bool AreClosed(const ResolvedBodies& bodies, const std::vector<FacetEdge>& edges)
{
  const std::vector<char> isClosed = FindClosedBodies(bodies, edges);
  return std::find(isClosed.begin(), isClosed.end(), 0) == isClosed.end();
}

FacetComplex ComplexOfBody(const ResolvedBodies& bodies, Id body)
{
  FacetComplex complex = bodies.Surface;
  for (Id f = 0; f < complex.NumberOfFacets(); ++f)
  {
    complex.Multiplicity[f] = static_cast<std::int16_t>(CountFor(bodies, f, body));
  }
  return complex;
}
} // namespace insideout
