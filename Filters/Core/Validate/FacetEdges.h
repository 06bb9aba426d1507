// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/RawVector.h"
#include "Common/Types.h"

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
void ForEachEdge(const FacetEdges& edges, Visitor visit)
{
  const FacetEdge* const end = edges.data() + edges.size();
  for (const FacetEdge* first = edges.data(); first != end;)
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

/** Components of facets that are joined through edges. */
struct FacetComponents
{
  std::vector<Id> Component; ///< per facet, numbered from 0 by their lowest facet
  Id Count = 0;
};

FacetComponents ComponentsOfFacets(Id numberOfFacets, const FacetEdges& edges);
} // namespace insideout
