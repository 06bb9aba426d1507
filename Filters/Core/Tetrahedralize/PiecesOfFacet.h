// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"

#include <vector>

namespace insideout
{
/** A facet as a union of smaller triangles, as it is when Steiner points lie on it. */
struct PiecesOfFacet
{
  /** The pieces, turned to the facet's orientation, in the order given. */
  std::vector<Triangle> Pieces;

  /** The points in the interior of edge k, from corner k to corner k + 1. */
  std::array<std::vector<Id>, 3> EdgePoints;
};

/**
 * Turn the pieces so that they agree with each other and with the facet, and prove that their
 * signed edges sum to its boundary: no edge belongs to more than two pieces, and the edges of only
 * one piece form one loop through the three corners in their order. No coordinates are used: where
 * points were rounded, the orientation of a sliver means nothing.
 *
 * @param[in] pieces triangles of three different points each
 * @param[out] result unspecified if the pieces are not the facet
 * @return whether the pieces are the facet
 */
bool MatchPiecesOfFacet(
  const Triangle& facet, const std::vector<Triangle>& pieces, PiecesOfFacet& result);

/**
 * The origin of a point that interpolates corners, each of which interpolates input points itself:
 * the weights are multiplied, and summed by input point. PointOrigin holds at most three input
 * points. If there are more, the origin is that of the corner with the largest weight, or that
 * corner itself if it is an input point.
 *
 * @param[in] corners origins of the corners
 * @param[in] weights at least 0, sum 1
 */
PointOrigin ComposeOrigin(
  const std::array<PointOrigin, 3>& corners, const std::array<double, 3>& weights);
} // namespace insideout
