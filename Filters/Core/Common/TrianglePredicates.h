// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Kernel.h"
#include "Common/PointPredicates.h"

/** Exact answers about triangles with double coordinates: filtered, so fast where nothing is near
 * degenerate. The triangles themselves must not be degenerate. */
namespace insideout
{
/** On which sides of the plane of `triangle` the corners of `other` lie: 1, 0 or -1 each. */
std::array<int, 3> SidesOfPlane(const FilteredTriangle& triangle, const FilteredTriangle& other);

/**
 * An axis along which the triangle can be projected: its image in the other two has an area. The
 * axis along which the normal is longest as far as doubles tell.
 */
int ProjectionAxis(const FilteredTriangle& triangle);

using ProjectedPoint = Kernel::Point_2;
using ProjectedTriangle = std::array<ProjectedPoint, 3>;

/** The point without the coordinate `axis`: (y, z), (z, x) or (x, y). */
ProjectedPoint Project(const FilteredPoint& point, int axis);
ProjectedTriangle Project(const FilteredTriangle& triangle, int axis);

/** Whether two triangles of one plane have an area in common. */
bool OverlapInPlane(const FilteredTriangle& a, const FilteredTriangle& b);

/** Whether a point of the triangle's plane lies in the triangle, boundary included. */
bool ContainsInPlane(const FilteredTriangle& triangle, const FilteredPoint& point);

/** Whether a segment through the triangle's plane meets the triangle, boundary included. */
bool Pierces(const FilteredPoint& p, const FilteredPoint& q, const FilteredTriangle& triangle);
} // namespace insideout
