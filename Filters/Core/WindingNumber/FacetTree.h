// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Box.h"
#include "WindingNumber/CountedBoundary.h"

namespace insideout
{
/**
 * A binary tree of triangles, split at the median along the longest side of the boxes that hold
 * their centers. Every triangle is in one leaf; nodes stand in depth-first order.
 */
struct FacetTree
{
  struct Node
  {
    Box Bounds; ///< of its triangles
    Id Begin;   ///< of these in Triangles
    Id End;
    Id Right; ///< its second child, None for a leaf; the first one is the next node

    bool IsLeaf() const { return this->Right == None; }
  };

  FacetTree(const std::vector<Point>& points, std::vector<CountedTriangle> triangles, Id leafSize);

  std::vector<CountedTriangle> Triangles; ///< reordered
  std::vector<Node> Nodes;
};
} // namespace insideout
