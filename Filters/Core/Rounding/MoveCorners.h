// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/BoxTree.h"
#include "Common/Types.h"

#include <set>
#include <vector>

namespace insideout
{
/**
 * Triangles whose corners can be moved a little, and edges that can be contracted, where that makes
 * no crossing more. Exact.
 */
class MoveCorners
{
public:
  /**
   * @param[in] points at different places
   * @param[in] triangles none degenerate, no two with the same three points
   * @param[in] reach how far a point may go from where it is now, along any axis
   */
  MoveCorners(std::vector<Point> points, std::vector<Triangle> triangles, double reach);

  const std::vector<Point>& Points() const { return this->Places; }
  const std::vector<Triangle>& Triangles() const { return this->Corners; }

  /** Whether the triangle was not contracted. */
  bool IsThere(Id triangle) const { return this->Alive[triangle] != 0; }

  /**
   * Contract the edge between two points, so that they are where `kept` is. Nothing changes if
   * there is no such edge, if more than the triangles beside it would merge, or if a triangle would
   * become degenerate or a crossing be added.
   */
  bool Contract(Id gone, Id kept);

  /** Move a point to the best of the floats around it, if there are fewer crossings then. */
  bool MoveToNeighbor(Id point);

  /** The corner in whose place the point is, after contractions. */
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
  const std::vector<Point> Begin; ///< where the points were
  const double Reach;
  std::vector<char> Alive;
  std::vector<Id> Into;                 ///< per point itself, or what it was contracted into
  std::vector<std::vector<Id>> AtPoint; ///< the triangles, with some that are gone
  std::set<Point> Taken;                ///< the places of the points
  BoxTree Tree;                         ///< of the triangles, widened by reach
};
} // namespace insideout
