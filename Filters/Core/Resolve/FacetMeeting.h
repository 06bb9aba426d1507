// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Resolve/ConstructedPoint.h"

namespace insideout
{
/** The intersection of two facets that meet: an area of their plane, or a segment. */
struct Meeting
{
  bool Overlap = false;
  bool InPlane = false; ///< whether both lie in one plane
  ConstructedPoint First;
  ConstructedPoint Last; ///< equal to First where they only touch
};

/**
 * How two facets meet, decided with exact predicates. For facets that overlap it has no further
 * details.
 *
 * @param[in] a, b non-degenerate facets that have a point in common
 */
Meeting Meet(const FacetList& surface, Id a, Id b);

/** The first and the last, by x, then y, then z, of one or more points on a line. */
std::array<ConstructedPoint, 2> Span(
  const FacetList& surface, const std::vector<ConstructedPoint>& points);

/** The edges of `facet`, or their parts, that lie in `other`, which is in the same plane. */
std::vector<std::array<ConstructedPoint, 2>> EdgesWithin(
  const FacetList& surface, Id facet, Id other);
} // namespace insideout
