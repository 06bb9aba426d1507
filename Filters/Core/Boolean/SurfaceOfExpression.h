// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Boolean/ResolveBodies.h"
#include "Boolean/SetExpression.h"
#include "Output/BoundaryTriangles.h"
#include "Output/Outliers.h"

#include <optional>

namespace insideout
{
/** The boundary of a set expression. */
struct ExpressionSurface
{
  std::vector<BoundaryTriangle> Boundary; ///< by points of bodies.Surface, in its facets' order
  std::vector<OutlierPiece> Outliers;     ///< facets with the expression false on both sides
  int MinimumW = 0;                       ///< of any body anywhere; 0 far away
  int MaximumW = 0;
};

/**
 * The boundary of a set expression of closed bodies, without any tetrahedra. A point is in a body
 * if w of the body is at least 1. The winding numbers of all bodies on both sides of each patch
 * decide: a patch is part of the surface if the expression is true on one side only (Zhou,
 * Grinspun, Zorin and Jacobson 2016, sections 4 and 5).
 *
 * The surface is watertight, and any two of its triangles meet only in shared points and edges. The
 * union of one body repairs it: self-intersections and inner walls are removed. The solid equals
 * that of the cut with weights for which IsCutByWholeNumbers (RealEnergy.h) is true.
 *
 * @param[in] bodies one for each of expression.Bodies()
 * @return nothing if a body is open or a facet was left out in resolving: its winding number then
 * requires a mesh
 * @throws Error (Stopped)
 */
std::optional<ExpressionSurface> SurfaceOfExpression(
  const ResolvedBodies& bodies, const SetExpression& expression, Monitor& monitor);
} // namespace insideout
