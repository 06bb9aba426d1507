// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/BoxTree.h"

#include <array>
#include <vector>

namespace insideout
{
/** Eight query points that lie side by side in registers. */
struct PointBlock
{
  static constexpr int Lanes = 8;

  double Of[3][Lanes]; ///< coordinates
  double Bound[Lanes]; ///< of the squared distance: facets beyond it are passed over
  double Room[Lanes];  ///< that bounds have to have above the squared distance of a facet
};

/** A facet that may be nearest to one of a block's points. */
struct NearFacet
{
  Id Facet;
  double Least[PointBlock::Lanes]; ///< its squared distance from each point is at least this
};

/**
 * Find the facets that may be nearest to one of a block's points: of each point those whose least
 * squared distance is at most its bound afterwards.
 *
 * @param[in] tree of the facets' boxes
 * @param[in,out] block bounds are lowered, and stay above the squared distance of the nearest
 * facet, and the room
 * @param[out] found in an order that is always the same
 */
void FindNearFacets(const BoxTree& tree, const std::vector<std::array<Point, 3>>& facets,
  PointBlock& block, std::vector<NearFacet>& found);
} // namespace insideout
