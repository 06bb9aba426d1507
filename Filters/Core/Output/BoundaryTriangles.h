// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Output/InsideBoundary.h"

namespace insideout
{
/** A triangle of the solid's boundary, before points are renumbered. */
struct BoundaryTriangle
{
  Triangle Corners; ///< points of the mesh, counter-clockwise seen from outside the solid
  Id Source;        ///< the input triangle that it lies on, None if it closes a hole
};

/**
 * The faces with the input triangles that they lie on. Several input triangles at one face: the
 * lowest that faces outward, else the lowest.
 *
 * @throws Error Stopped
 */
std::vector<BoundaryTriangle> BoundaryTriangles(const FacetComplex& surface,
  const TetrahedralMesh& mesh, const std::vector<BoundaryFace>& faces, Monitor& monitor,
  const ProgressRange& progress);

/**
 * The volume that a watertight surface encloses, to some units in the last place.
 *
 * @param[in] points referred to by its corners
 */
double VolumeWithin(
  const std::vector<Point>& points, const std::vector<BoundaryTriangle>& triangles);

/**
 * The input triangles by points of the mesh.
 *
 * @param[in] mergedInto as CountedChain's
 * @param[in] origins of the mesh's points
 * @return one per input triangle, with None for points that no facet uses
 */
std::vector<Triangle> TrianglesInMesh(const TriangleSoup& soup, const std::vector<Id>& mergedInto,
  const std::vector<PointOrigin>& origins);
} // namespace insideout
