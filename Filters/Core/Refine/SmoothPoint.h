// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Refine/RefinableSurface.h"
#include "Refine/SurfaceBound.h"

#include <vector>

namespace insideout
{
/**
 * Moves points to improve the worst shape of the cells around them: points on no facet anywhere,
 * points within facets along the surface.
 */
class PointSmoothing : public SurfaceOperator
{
public:
  using SurfaceOperator::SurfaceOperator;

  /** @return whether the point moved: only if the worst shape (ShapeOf) around it improves */
  bool Smooth(Id point);

  /**
   * Move a point within facets to the center of the points around it, if the shapes around it are
   * then above `wanted`, or half as good as before.
   */
  bool Relax(Id point, double wanted);

private:
  void CollectPieces(Id point);
  Point NormalOfPieces() const;
  Point PlaceOnSurface(const Point& place) const;
  bool SmoothInFacet(Id point);
  bool MoveInFacet(Id point, const Point& place);
  bool MoveTo(Id point, const Point& place);

  std::vector<Id> Cells;
  std::vector<Triangle> Walls;      ///< walls of the star, counter-clockwise seen from the point
  std::vector<SurfacePiece> Pieces; ///< at a point within facets
  std::vector<SurfacePiece> Moved;
};
} // namespace insideout
