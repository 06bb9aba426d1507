// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/BoxTree.h"
#include "WindingNumber/CountedBoundary.h"

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
    const std::vector<Point>& points, std::vector<CountedTriangle> triangles);

  /** The winding number at a point; triangles in whose plane it lies count 0. */
  double At(const Point& p) const;

private:
  /** The facets of a part of the tree. */
  struct Part
  {
    Box Around = Box::Empty();
    std::size_t Size = 0;
    std::vector<CountedEdge> Boundary;
  };

  /** What replaces them outside of their box. */
  struct Fan
  {
    Box Around;
    bool Replaces; ///< has fewer triangles than the part
    std::vector<CountedTriangle> Triangles;
  };

  Part LeafOf(Id part) const;
  static Fan Close(const Part& part);
  double WindingNumberOf(const CountedTriangle& triangle, const Point& p) const;

  const std::vector<Point>& Points;
  const std::vector<CountedTriangle> Triangles;
  const BoxTree Tree;
  std::vector<Fan> Fans; ///< one per part
};
} // namespace insideout
