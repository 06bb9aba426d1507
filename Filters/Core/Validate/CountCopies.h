// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Validate/FacetEdges.h"

#include <cstdint>

namespace insideout
{
struct FacetComplex;

/**
 * The numbers of a facet's copies that are given, or count, along its own orientation and against
 * it.
 */
struct FacetCopies
{
  std::int64_t Along = 0;
  std::int64_t Against = 0;

  bool operator==(const FacetCopies& other) const
  {
    return this->Along == other.Along && this->Against == other.Against;
  }
};

/**
 * Decide how many copies of facets count: as many as close the surface.
 *
 * A repeated facet may be an error, or belong to several closed shells. At first each facet counts
 * once per orientation. Sets of adjacent facets with the same copies then count once more while
 * this shortens the open boundary, the sum of edge lengths times their signed sums. One of two
 * opposite copies does not count if the other alone leaves no open boundary there. Sets may depend
 * on each other, so the reverse is tried, too: all copies count, and are removed while this
 * shortens the boundary. The shorter of the two boundaries wins; on ties the first.
 *
 * @param[in] edges those of surface.Facets
 * @param[in] given one per facet
 * @return one per facet, at most the given copies; at least one
 */
std::vector<FacetCopies> CountCopies(
  const FacetComplex& surface, const FacetEdges& edges, const std::vector<FacetCopies>& given);
} // namespace insideout
