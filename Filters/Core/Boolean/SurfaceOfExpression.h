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
 * where w of the body is 1 or more. The winding numbers of all bodies on both sides of each patch
 * decide: a patch with the expression true on one side only is part of the surface (Zhou, Grinspun,
 * Zorin and Jacobson 2016, sections 4 and 5).
 *
 * It is watertight, and no two of its triangles meet but in shared points and edges. The union of
 * one body is its repair: self-intersections and inner walls are gone. The solid equals that of the
 * cut with weights for which IsCutByWholeNumbers (CutEnergy.h) is true.
 *
 * @param[in] bodies one for each of expression.Bodies()
 * @return nothing where a body is not closed, or a facet was left out in resolving: its winding
 * number then takes a mesh
 * @throws Error (Stopped)
 */
std::optional<ExpressionSurface> SurfaceOfExpression(
  const ResolvedBodies& bodies, const SetExpression& expression, Monitor& monitor);
} // namespace insideout
