// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/GmpMemory.h"
#include "Common/Types.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <vector>

/** CGAL's geometry. For signs only, PointPredicates.h compiles faster. */
namespace insideout
{
/** Predicates are exact, and filtered: fast unless nearly degenerate. Constructions are rounded. */
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using FilteredPoint = Kernel::Point_3;
using FilteredTriangle = std::array<FilteredPoint, 3>;

inline FilteredPoint ToFiltered(const Point& point)
{
  return { point[0], point[1], point[2] };
}

inline FilteredTriangle ToFiltered(const std::vector<Point>& points, const Triangle& corners)
{
  return { ToFiltered(points[corners[0]]), ToFiltered(points[corners[1]]),
    ToFiltered(points[corners[2]]) };
}
} // namespace insideout
