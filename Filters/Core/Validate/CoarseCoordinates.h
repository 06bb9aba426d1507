// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"
#include "Validate/FacetEdges.h"

#include <string>
#include <vector>

namespace insideout
{
/** Coordinates that single precision has rounded. */
struct CoarseCoordinates
{
  double Step = 0; ///< between neighboring floats, of the largest coordinates; 0: not rounded
  double Edge = 0; ///< the median length of edges

  static constexpr double TooCoarse = 0.25; ///< such a part of an edge decides about shapes

  bool AreTooCoarse() const { return this->Step > 0 && this->Step >= TooCoarse * this->Edge; }
};

/**
 * The step of single precision, where all points are floats. That of an axis along which no point
 * has an odd multiple of it does not count: such coordinates, as whole numbers, are coarse by
 * themselves.
 *
 * @param[in] points finite
 * @param[in] edges of facets with these points
 */
CoarseCoordinates FindCoarseCoordinates(
  const std::vector<Point>& points, const std::vector<FacetEdge>& edges);

/** The step, the edge, and what to do about it. */
std::string WarningAbout(const CoarseCoordinates& coordinates);
} // namespace insideout
