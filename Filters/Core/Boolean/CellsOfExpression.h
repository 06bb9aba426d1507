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
 * The cells in which a set expression holds, of bodies that may be open. One mesh has the facets of
 * all; each body has its own winding number per cell and its own cut (SegmentBodies).
 *
 * Narrow gaps between bodies are closed first (FillGaps); each goes to the last adjacent body.
 *
 * If all bodies are closed, the boundary equals that of SurfaceOfExpression, except for points that
 * the mesh adds. If all facets lie in one plane, there are no cells, and a warning says so.
 *
 * @param[in] bodies one for each of expression.Bodies()
 * @param[in] names of these, for messages
 * @param[in] mergeTolerance largest width of gaps; 0 closes none
 * @throws Error as ConstrainedDelaunay, WindingNumbersOfBodies and SegmentBodies do
 */
CellsOfExpression FindCellsOfExpression(const ResolvedBodies& bodies,
  const std::vector<std::string>& names, const SetExpression& expression, double mergeTolerance,
  Monitor& monitor);
} // namespace insideout
