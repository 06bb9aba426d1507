// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "WindingNumber/FacetTree.h"

namespace insideout
{
/**
 * The winding number by the thesis's own hierarchy (chapter 8): a tree of facets in which every
 * node's open boundary is closed with a fan. Outside the node's box the facets and the fan together
 * have winding number 0, so there the fan replaces the facets if it has fewer triangles. Exact but
 * for rounding, with an arctangent per triangle. For reference: ExactWindingNumber.h is faster.
 */
class HierarchicalWindingNumber
{
public:
  /** @param[in] points below 1 in each coordinate; has to live as long as this object */
  HierarchicalWindingNumber(
    const std::vector<Point>& points, const std::vector<CountedTriangle>& triangles);

  /** The winding number at a point; triangles in whose plane it lies count 0. */
  double At(const Point& p) const;

private:
  double SumOf(const CountedTriangle* first, const CountedTriangle* last, const Point& p) const;
  std::vector<CountedEdge> CloseNodes(std::size_t node);
  void CloseNode(std::size_t node, const std::vector<CountedEdge>& boundary);

  const std::vector<Point>& Points;
  FacetTree Tree;
  struct Fan
  {
    bool Replaces = false; ///< has fewer triangles than the node
    std::vector<CountedTriangle> Triangles;
  };
  std::vector<Fan> Fans; ///< one per node
};
} // namespace insideout
