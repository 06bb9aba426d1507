// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Validate/FacetEdges.h"

#include <cstdint>

namespace insideout
{
struct FacetComplex;

/** How often a facet is given, or counts, along its own orientation and against it. */
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
 * Which copies of facets count: as many as close the surface.
 *
 * A facet that is given several times may be a slip, or belong to several closed shells. At first
 * each facet counts once per orientation. Sets of adjacent facets that are given alike then count
 * once more as long as that shortens the open boundary, the length of edges times their signed
 * sums; and one of two opposite copies does not count if the other alone leaves no open boundary
 * there. As sets may need each other, the same is tried from the other end: all copies count, and
 * are taken away as long as that shortens the boundary. The shorter of the two boundaries wins, of
 * equal ones the first.
 *
 * @param[in] edges those of surface.Facets
 * @param[in] given one per facet
 * @return one per facet, at most what is given; at least once
 */
std::vector<FacetCopies> CountCopies(const FacetComplex& surface,
  const std::vector<FacetEdge>& edges, const std::vector<FacetCopies>& given);
} // namespace insideout
