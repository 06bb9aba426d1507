// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Refine/RefinableMesh.h"

#include <vector>

namespace insideout
{
/** Moves points that are on no facet to where the worst shape of the cells around them is best. */
class PointSmoothing
{
public:
  explicit PointSmoothing(RefinableMesh& mesh)
    : Mesh(mesh)
  {
  }

  /** @return whether the point moved: only where the worst shape (ShapeOf) around it gets better */
  bool Smooth(Id point);

private:
  void Collect(Id point);
  bool MoveTo(Id point, const Point& place);

  RefinableMesh& Mesh;
  std::vector<Id> Cells;
  std::vector<Triangle> Walls; ///< of the star, counter-clockwise seen from the point
};
} // namespace insideout
