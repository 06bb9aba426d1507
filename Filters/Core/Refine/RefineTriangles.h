// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/Statistics.h"
#include "Planar/FindPlane.h"
#include "Planar/PlanarCurve.h"
#include "Refine/RefineTetrahedra.h"

#include <string>

namespace insideout
{
/** Better triangles of what is inside, and the curve that they respect. */
struct RefinedTriangles
{
  SegmentComplex Curve; ///< the pieces of segments at inside cells, with their sources
  PlanarMesh Mesh;      ///< of the inside cells
  std::vector<Id>
    OriginalPoints;              ///< per point, the one of the input that it is, None for a new one
  std::vector<Id> CellsOfPoints; ///< per point, a cell of the input that holds it, or is near it

  /** Per cell, the one of the input that holds its barycenter, or is near it; on the same side of
   * all segments. */
  std::vector<Id> OriginalCells;
  insideout::Statistics Statistics;
  std::vector<std::string> Warnings;
};

/**
 * Triangles of the same inside that are better and as large as asked for, by Delaunay refinement:
 * the center of the circumcircle of a triangle that is too large or too thin becomes a point
 * (Ruppert 1995). Constraints are the boundary and all segments at inside cells. Kept: these stay
 * as they are, and no angle comes to be below 20.7 degrees that is less than those in its place
 * were; where lengths or areas are asked for, below 10: beside long constraints triangles stay
 * larger, and a warning counts them. Split: a constraint is cut where a center or a point is within
 * the circle around it, or where it is too long; then no angle is below 20.7 degrees but near sharp
 * corners of the curve. Cuts near corners below 60 degrees are at powers of two from these
 * (Ruppert's concentric shells). The triangle at such a corner stays thin; and below half a
 * degree all those between shells, for good ones would be too many.
 *
 * Every triangle is positive, exactly, and the same for the same input, always.
 *
 * Statistics: AddedPoints; SurfacePoints, those on constraints; CellsAboveMaximumVolume where that
 * is given; RefinedCells; MinAngle, Angle1Percent, MaxAngle, in degrees, and with Before in front
 * those of the input.
 *
 * @param[in] inside one value per cell of the mesh, 0 for those that are left out
 * @param[in] parameters lengths are in the units of the input; MaximumVolume is the largest area
 * @throws Error InvalidParameter where the surface is to be remeshed, TooLarge when there would be
 *         more cells than can be counted, Stopped
 */
RefinedTriangles RefineTriangles(const SegmentComplex& curve, const PlanarMesh& mesh,
  const std::vector<unsigned char>& inside, const Plane& plane,
  const RefinementParameters& parameters, Monitor& monitor);
} // namespace insideout
