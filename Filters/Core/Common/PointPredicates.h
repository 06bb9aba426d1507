// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <vector>

/** Exact predicates of points with double coordinates, filtered: fast unless nearly degenerate. */
namespace insideout
{
/** The side of c seen from a to b: 1 left, 0 on the line, -1 right. */
int Orient2D(
  const std::array<double, 2>& a, const std::array<double, 2>& b, const std::array<double, 2>& c);

/** The sign of the volume of a tetrahedron, positive if a, b, c run counter-clockwise seen from d.
 */
int Orient3D(const Point& a, const Point& b, const Point& c, const Point& d);
int Orient3D(const std::vector<Point>& points, const Tetrahedron& cell);

/** Whether three points lie on a line. */
bool IsDegenerate(const Point& a, const Point& b, const Point& c);
bool IsDegenerate(const std::vector<Point>& points, const Triangle& corners);
} // namespace insideout
