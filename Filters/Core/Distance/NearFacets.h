// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/BoxTree.h"

#include <array>
#include <vector>

namespace insideout
{
/** Eight query points, one per vector lane. */
struct PointBlock
{
  static constexpr int Lanes = 8;

  double Of[3][Lanes]; ///< coordinates
  double Bound[Lanes]; ///< bounds of the squared distance: farther facets are skipped
  double Room[Lanes];  ///< required margin of bounds above the squared distance of a facet
};

/** A facet that may be nearest to one of a block's points. */
struct NearFacet
{
  Id Facet;
  double Least[PointBlock::Lanes]; ///< lower bounds of its squared distance from each point
};

/**
 * Find the facets that may be nearest to one of a block's points: for each point those whose least
 * squared distance is at most its final bound.
 *
 * @param[in] tree of the facets' boxes
 * @param[in,out] block bounds are lowered, and stay above the squared distance of the nearest
 * facet, and the room
 * @param[out] found in a deterministic order
 */
void FindNearFacets(const BoxTree& tree, const std::vector<std::array<Point, 3>>& facets,
  PointBlock& block, std::vector<NearFacet>& found);
} // namespace insideout
