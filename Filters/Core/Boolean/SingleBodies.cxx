// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/SingleBodies.h"

#include <algorithm>

namespace insideout
{
std::vector<char> FindClosedBodies(const ResolvedBodies& bodies, const FacetEdges& edges)
{
  std::vector<char> isClosed(bodies.Bodies.size(), 1);
  const auto forCounts = [&](const FacetEdge* first, const FacetEdge* last, const auto& visit)
  {
    for (const FacetEdge* edge = first; edge != last; ++edge)
    {
      for (Id i = bodies.CountOffsets[edge->Facet]; i < bodies.CountOffsets[edge->Facet + 1]; ++i)
      {
        visit(bodies.BodyCounts[i].Body, edge->Direction * bodies.BodyCounts[i].Count);
      }
    }
  };
  const double nanosecondsPerEdge = 5;
  ForBlocksOfEdges(edges, nanosecondsPerEdge,
    [&](const FacetEdge* begin, const FacetEdge* end)
    {
      std::vector<int> sums(isClosed.size(), 0);
      ForEachEdge(begin, end,
        [&](const FacetEdge* first, const FacetEdge* last)
        {
          forCounts(first, last, [&](Id body, int count) { sums[body] += count; });
          forCounts(first, last,
            [&](Id body, int)
            {
              if (sums[body] != 0)
              {
                __atomic_store_n(&isClosed[body], char(0), __ATOMIC_RELAXED);
                sums[body] = 0;
              }
            });
        });
    });
  return isClosed;
}

bool AreClosed(const ResolvedBodies& bodies, const FacetEdges& edges)
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
