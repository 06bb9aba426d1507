// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/BoxTree.h"
#include "Common/Types.h"

#include <set>
#include <vector>

namespace insideout
{
/**
 * Triangles whose corners can be moved slightly, and whose edges can be contracted, unless this
 * adds crossings. Exact.
 */
class MoveCorners
{
public:
  /**
   * @param[in] points at different places
   * @param[in] triangles none degenerate, no two with the same three points
   * @param[in] reach limit of a point's movement from its present place, along any axis
   */
  MoveCorners(std::vector<Point> points, std::vector<Triangle> triangles, double reach);

  const std::vector<Point>& Points() const { return this->Places; }
  const std::vector<Triangle>& Triangles() const { return this->Corners; }

  /** Whether the triangle still exists after contractions. */
  bool IsThere(Id triangle) const { return this->Alive[triangle] != 0; }

  /**
   * Contract the edge between two points to the place of `kept`. Nothing changes if there is no
   * such edge, if more than the triangles beside it would merge, or if a triangle would become
   * degenerate or a crossing be added.
   */
  bool Contract(Id gone, Id kept);

  /** Move a point to the best of the floats around it, if that reduces crossings. */
  bool MoveToNeighbor(Id point);

  /** The corner that replaces the point after contractions. */
  Id CornerOf(Id point) const;

private:
  bool CanTake(Id point, const Point& place) const;
  bool IsLinkSound(Id gone, Id kept, std::vector<Id>& between) const;
  int CrossingsAround(const std::vector<Id>& star) const;
  bool MeetsAnother(Id triangle, Id other) const;
  bool AnyDegenerate(const std::vector<Id>& star) const;
  std::vector<Id> StarOf(Id point) const;
  std::vector<Id> Neighbors(Id point) const;

  std::vector<Point> Places;
  std::vector<Triangle> Corners;
  const std::vector<Point> Begin; ///< original places of the points
  const double Reach;
  std::vector<char> Alive;
  std::vector<Id> Into;                 ///< per point itself, or the point it was contracted into
  std::vector<std::vector<Id>> AtPoint; ///< the triangles, including removed ones
  std::set<Point> Taken;                ///< current places of the points
  BoxTree Tree;                         ///< boxes of the triangles, widened by reach
};
} // namespace insideout
