// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "WindingNumber/CountedBoundary.h"

namespace insideout
{
/**
 * A binary tree of triangles, split at the median along the longest side of the boxes that hold
 * their centres. Every triangle is in one leaf; nodes stand in depth-first order.
 */
struct FacetTree
{
  struct Node
  {
    Point Low; ///< of the triangles' bounding box
    Point High;
    Id Begin; ///< of its triangles in Triangles
    Id End;
    Id Right; ///< its second child, None for a leaf; the first one is the next node

    bool IsLeaf() const { return this->Right == None; }
    bool Holds(const Point& p) const
    {
      return p[0] >= this->Low[0] && p[0] <= this->High[0] && p[1] >= this->Low[1] &&
        p[1] <= this->High[1] && p[2] >= this->Low[2] && p[2] <= this->High[2];
    }
  };

  FacetTree(const std::vector<Point>& points, std::vector<CountedTriangle> triangles, Id leafSize);

  std::vector<CountedTriangle> Triangles; ///< reordered
  std::vector<Node> Nodes;
};
} // namespace insideout
