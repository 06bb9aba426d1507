// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Refine/RefinableSurface.h"
#include "Refine/SurfaceBound.h"

#include <vector>

namespace insideout
{
/**
 * Moves points to where the worst shape of the cells around them is best: those on no facet
 * anywhere, those amid facets along the surface.
 */
class PointSmoothing
{
public:
  PointSmoothing(RefinableMesh& mesh, const RefinableSurface& surface, SurfaceBound& bound)
    : Mesh(mesh)
    , Surface(surface)
    , Bound(bound)
  {
  }

  /** @return whether the point moved: only where the worst shape (ShapeOf) around it gets better */
  bool Smooth(Id point);

  /**
   * Move a point amid facets to the middle of those around it, if the shapes around it are above
   * `wanted` then, or half as good as before.
   */
  bool Relax(Id point, double wanted);

private:
  void CollectPieces(Id point);
  Point NormalOfPieces() const;
  Point PlaceOnSurface(const Point& place) const;
  bool SmoothInFacet(Id point);
  bool MoveInFacet(Id point, const Point& place);
  bool MoveTo(Id point, const Point& place);

  RefinableMesh& Mesh;
  const RefinableSurface& Surface;
  SurfaceBound& Bound;
  std::vector<Id> Cells;
  std::vector<Triangle> Walls;      ///< of the star, counter-clockwise seen from the point
  std::vector<SurfacePiece> Pieces; ///< at a point amid facets
  std::vector<SurfacePiece> Moved;
};
} // namespace insideout
