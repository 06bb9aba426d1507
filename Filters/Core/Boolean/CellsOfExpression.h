// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Boolean/ResolveBodies.h"
#include "Boolean/SetExpression.h"
#include "Output/BoundaryTriangles.h"

namespace insideout
{
/** The result of a set expression, in tetrahedra. */
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
 * all, and each body has its own winding number in each cell and its own cut (SegmentBodies).
 *
 * Narrow gaps between bodies are closed first (FillGaps); each belongs to the last adjacent body.
 *
 * If all bodies are closed, the boundary is that of SurfaceOfExpression, except for points that the
 * mesh adds. Where all facets lie in one plane there are no cells, with a warning.
 *
 * @param[in] bodies one for each of expression.Bodies()
 * @param[in] names of these, for messages
 * @param[in] mergeTolerance of gaps; 0 closes none
 * @throws Error as ConstrainedDelaunay, WindingNumbersOfBodies and SegmentBodies do
 */
CellsOfExpression FindCellsOfExpression(const ResolvedBodies& bodies,
  const std::vector<std::string>& names, const SetExpression& expression, double mergeTolerance,
  Monitor& monitor);
} // namespace insideout
