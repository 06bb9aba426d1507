// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"
#include "Validate/FacetEdges.h"

#include <string>
#include <vector>

namespace insideout
{
/** The effect of coordinates rounded to single precision. */
struct CoarseCoordinates
{
  /// the step between neighboring floats at the largest coordinates; 0: not rounded
  double Step = 0;
  double Edge = 0; ///< the median length of edges

  /// fraction of an edge from which a step matters for shapes
  static constexpr double TooCoarse = 0.25;

  bool AreTooCoarse() const { return this->Step > 0 && this->Step >= TooCoarse * this->Edge; }
};

/**
 * The step of single precision, if all coordinates are floats. An axis along which no coordinate is
 * an odd multiple of its step is left out: such coordinates, for example whole numbers, are coarse
 * by nature.
 *
 * @param[in] points finite
 * @param[in] edges of facets with these points
 */
CoarseCoordinates FindCoarseCoordinates(const std::vector<Point>& points, const FacetEdges& edges);

/** A message with the step, the edge, and a remedy. */
std::string WarningAbout(const CoarseCoordinates& coordinates);
} // namespace insideout
