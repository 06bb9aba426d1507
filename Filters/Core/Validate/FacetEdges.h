// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/ParallelLoop.h"
#include "Common/RawVector.h"
#include "Common/Types.h"

#include <algorithm>

namespace insideout
{
/**
 * An edge of one facet: Direction is +1 if the facet runs from Low to High, -1 from High to Low.
 */
struct FacetEdge
{
  Id Low;
  Id High;
  Id Facet;
  int Direction;
};

using FacetEdges = RawVector<FacetEdge>;

/** The three edges of every facet, sorted by edge, then by facet. */
FacetEdges SortedFacetEdges(const std::vector<Triangle>& facets);

/** Call visit(first, last) with the range of FacetEdges of each edge, in order. */
template <typename Visitor>
void ForEachEdge(const FacetEdge* begin, const FacetEdge* end, Visitor visit)
{
  for (const FacetEdge* first = begin; first != end;)
  {
    const FacetEdge* last = first + 1;
    while (last != end && last->Low == first->Low && last->High == first->High)
    {
      ++last;
    }
    visit(first, last);
    first = last;
  }
}

template <typename Visitor>
void ForEachEdge(const FacetEdges& edges, const Visitor& visit)
{
  ForEachEdge(edges.data(), edges.data() + edges.size(), visit);
}

/**
 * Call work(begin, end), on several threads, for ranges that hold all FacetEdges of their edges.
 * @param[in] cost estimated nanoseconds for each FacetEdge
 */
template <typename Work>
void ForBlocksOfEdges(const FacetEdges& edges, double cost, const Work& work)
{
  constexpr std::size_t BlockSize = 8192;
  const auto beginOf = [&](std::size_t block)
  {
    std::size_t at = std::min(block * BlockSize, edges.size());
    while (at > 0 && at < edges.size() && edges[at].Low == edges[at - 1].Low &&
      edges[at].High == edges[at - 1].High)
    {
      ++at;
    }
    return edges.data() + at;
  };
  ParallelLoop((edges.size() + BlockSize - 1) / BlockSize, cost * BlockSize,
    [&](std::size_t block) { work(beginOf(block), beginOf(block + 1)); });
}

/** Components of facets that are joined through edges. */
struct FacetComponents
{
  std::vector<Id> Component; ///< per facet, numbered from 0 by their lowest facet
  Id Count = 0;
};

FacetComponents ComponentsOfFacets(Id numberOfFacets, const FacetEdges& edges);
} // namespace insideout
