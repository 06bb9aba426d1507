// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <vector>

/** Exact answers about triangles with double coordinates: filtered, so fast where nothing is near
 * degenerate. The triangles themselves must not be degenerate. */
namespace insideout
{
using FilteredKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using FilteredPoint = FilteredKernel::Point_3;
using FilteredTriangle = std::array<FilteredPoint, 3>;

std::vector<FilteredPoint> ToFiltered(const std::vector<Point>& points);

/** Whether three points lie on a line. */
bool IsDegenerate(const Point& a, const Point& b, const Point& c);

/**
 * On which sides of the plane of `triangle` the corners of `other` lie: 1, 0 or -1 each.
 */
std::array<int, 3> SidesOfPlane(const FilteredTriangle& triangle, const FilteredTriangle& other);

/**
 * An axis along which the triangle can be projected: its image in the other two has an area. Of
 * the three, the one along which the normal is longest as far as doubles tell.
 */
int ProjectionAxis(const FilteredTriangle& triangle);

/** The point without the coordinate `axis`: (y, z), (z, x) or (x, y). */
FilteredKernel::Point_2 Project(const FilteredPoint& point, int axis);

/** Whether two triangles of one plane have an area in common. */
bool OverlapInPlane(const FilteredTriangle& a, const FilteredTriangle& b);

/** Whether a point of the triangle's plane lies in the triangle, boundary included. */
bool ContainsInPlane(const FilteredTriangle& triangle, const FilteredPoint& point);

/**
 * Whether two triangles meet in more than the corners, and the edge between them, that they share
 * by id. Equal coordinates under two ids are no shared corner. The three ids must not all agree.
 */
bool MeetBeyondSharedCorners(
  const std::vector<FilteredPoint>& points, const Triangle& a, const Triangle& b);
} // namespace insideout
