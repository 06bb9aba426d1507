// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Kernel.h"
#include "Common/PointPredicates.h"

/** Exact predicates of triangles with double coordinates, filtered: fast unless nearly degenerate.
 * The triangles themselves must not be degenerate. */
namespace insideout
{
/** The sides of the plane of `triangle` on which the corners of `other` lie: 1, 0 or -1 each. */
std::array<int, 3> SidesOfPlane(const FilteredTriangle& triangle, const FilteredTriangle& other);

/**
 * An axis along which the triangle can be projected: its image in the other two has an area.
 * Preferably the normal's longest component, as computed in doubles.
 */
int ProjectionAxis(const FilteredTriangle& triangle);

using ProjectedPoint = Kernel::Point_2;
using ProjectedTriangle = std::array<ProjectedPoint, 3>;

/** The point without the coordinate `axis`: (y, z), (z, x) or (x, y). */
ProjectedPoint Project(const FilteredPoint& point, int axis);
ProjectedTriangle Project(const FilteredTriangle& triangle, int axis);

/** Whether two coplanar triangles overlap in an area. */
bool OverlapInPlane(const FilteredTriangle& a, const FilteredTriangle& b);

/** Whether a point of the triangle's plane lies in the triangle, boundary included. */
bool ContainsInPlane(const FilteredTriangle& triangle, const FilteredPoint& point);

/** Whether a segment through the triangle's plane meets the triangle, boundary included. */
bool Pierces(const FilteredPoint& p, const FilteredPoint& q, const FilteredTriangle& triangle);
} // namespace insideout
