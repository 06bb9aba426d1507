// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "Common/Monitor.h"

namespace insideout
{
/** Two facets of different bodies that lie on each other, up to a gap. */
struct TouchingPair
{
  Id First; ///< of the earlier body
  Id Second;
  double Distance; ///< the widest gap where they lie on each other
};

/**
 * Find pairs of facets of different bodies that lie on each other: in an area wider than their
 * tolerance, they are nowhere farther apart than it. Thin facets may be inclined, and facets may
 * end in other planes.
 *
 * @param[in] bodyOf of each facet
 * @param[in] tolerances per facet, negative for facets that touch none; the tolerance of a pair is
 * their sum
 * @return by first, then by second
 * @throws Error (Stopped)
 */
std::vector<TouchingPair> FindTouchingFacets(const std::vector<Point>& points,
  const std::vector<Triangle>& facets, const std::vector<Id>& bodyOf,
  const std::vector<double>& tolerances, Monitor& monitor);
} // namespace insideout
