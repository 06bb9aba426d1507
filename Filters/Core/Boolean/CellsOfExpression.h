// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Boolean/ResolveBodies.h"
#include "Boolean/SetExpression.h"
#include "Output/BoundaryTriangles.h"

namespace insideout
{
/** What a set expression makes of bodies, in tetrahedra. */
struct CellsOfExpression
{
  TetrahedralMesh Mesh;                   ///< of the convex hull of all bodies
  std::vector<unsigned char> Inside;      ///< 1 or 0 per cell: whether the expression holds there
  std::vector<BoundaryTriangle> Boundary; ///< of these cells, by points of the mesh
  insideout::Statistics Statistics;
  std::vector<std::string> Warnings;
};

/**
 * The cells where a set expression holds, of bodies that may be open: one mesh has the facets of
 * all, and each body a winding number of its own in each cell, and a cut of its own
 * (SegmentBodies).
 *
 * Narrow gaps between bodies are closed first (FillGaps); of the bodies beside one the last gets
 * it.
 *
 * Where all bodies are closed their boundary is SurfaceOfExpression, but for points that the mesh
 * adds. Where all facets lie in one plane there are no cells, with a warning.
 *
 * @param[in] bodies one for each of expression.Bodies()
 * @param[in] names of these, for messages
 * @param[in] mergeTolerance of gaps; 0 closes none
 * @throws Error whatever ConstrainedDelaunay, WindingNumbersOfBodies and SegmentBodies throw
 */
CellsOfExpression FindCellsOfExpression(const ResolvedBodies& bodies,
  const std::vector<std::string>& names, const SetExpression& expression, double mergeTolerance,
  Monitor& monitor);
} // namespace insideout
