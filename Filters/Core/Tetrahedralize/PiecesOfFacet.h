// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"

#include <vector>

namespace insideout
{
/** A facet as a union of smaller triangles, which it is where Steiner points lie on it. */
struct PiecesOfFacet
{
  /** The pieces, turned to the facet's orientation, in the order given. */
  std::vector<Triangle> Pieces;

  /** The points on edge k, between corners k and k + 1, in this order, ends left out. */
  std::array<std::vector<Id>, 3> EdgePoints;
};

/**
 * Turn the pieces so that they agree with each other and with the facet, and prove that their
 * signed edges sum to its boundary: no edge has more than two pieces, and the edges of one piece
 * form one loop through the three corners in their order. This asks for no coordinates: on a facet
 * whose points were rounded, the orientation of a sliver means nothing.
 *
 * @param[in] pieces triangles of three different points each
 * @param[out] result unspecified where the answer is no
 * @return whether the pieces are the facet
 */
bool MatchPiecesOfFacet(
  const Triangle& facet, const std::vector<Triangle>& pieces, PiecesOfFacet& result);

/**
 * The origin of a point that interpolates corners, each of which interpolates input points itself:
 * the weights multiplied and summed by input point. Where more than three input points take part,
 * PointOrigin cannot say it; then it is the origin of the corner with the largest weight, or like
 * it where that is an input point.
 *
 * @param[in] corners origins of the corners, none from nowhere
 * @param[in] weights at least 0, sum 1
 */
PointOrigin ComposeOrigin(
  const std::array<PointOrigin, 3>& corners, const std::array<double, 3>& weights);
} // namespace insideout
