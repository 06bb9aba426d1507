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
/** Better triangles of the inside, and the curve that they respect. */
struct RefinedTriangles
{
  SegmentComplex Curve;           ///< the pieces of segments at inside cells, with their sources
  PlanarMesh Mesh;                ///< of the inside cells
  std::vector<Id> OriginalPoints; ///< per point, the input point that it is, None for a new one
  std::vector<Id> CellsOfPoints;  ///< per point, an input cell that contains it, or is near it

  /** Per cell, the input cell that contains its barycenter, or is near it; on the same side of all
   * segments. */
  std::vector<Id> OriginalCells;
  insideout::Statistics Statistics;
  std::vector<std::string> Warnings;
};

/**
 * Refine the inside to better triangles of the requested sizes, by Delaunay refinement: the center
 * of the circumcircle of a triangle that is too large or too thin becomes a point (Ruppert 1995).
 * Constraints are the boundary and all segments at inside cells. Kept: constraints stay as they
 * are, and no new angle below 20.7 degrees is smaller than those it replaces; if lengths or areas
 * are given, 10 degrees. Beside long constraints triangles stay larger, and a warning counts them.
 * Split: a constraint is split if a center or a point is within its diametral circle, or if it is
 * too long; then all angles are at least 20.7 degrees except near sharp corners of the curve.
 * Splits near corners below 60 degrees are at powers of two from these (Ruppert's concentric
 * shells). The triangle at such a corner stays thin; at corners below half a degree so do all
 * between shells, because good ones would be too many.
 *
 * Every triangle is exactly positive. The result is deterministic.
 *
 * Statistics: AddedPoints; SurfacePoints, those on constraints; CellsAboveMaximumVolume if that is
 * given; RefinedCells; MinAngle, Angle1Percent, MaxAngle, in degrees, and the same of the input
 * prefixed with Before.
 *
 * @param[in] inside one value per cell of the mesh, 0 for those that are left out
 * @param[in] parameters lengths are in the units of the input; MaximumVolume is the largest area
 * @throws Error InvalidParameter if the surface is to be remeshed, TooLarge if there would be more
 *         cells than can be counted, Stopped
 */
RefinedTriangles RefineTriangles(const SegmentComplex& curve, const PlanarMesh& mesh,
  const std::vector<unsigned char>& inside, const Plane& plane,
  const RefinementParameters& parameters, Monitor& monitor);
} // namespace insideout
