// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/TrianglePredicates.h"

namespace insideout
{
/**
 * Whether two triangles meet in more than the corners, and the edge between them, that they share
 * by id. Equal coordinates under two ids are no shared corner. The three ids must not all agree.
 */
bool MeetBeyondSharedCorners(
  const std::vector<FilteredPoint>& points, const Triangle& a, const Triangle& b);

/** The same of triangles by ids and places. */
bool MeetBeyondSharedCorners(const Triangle& a, const FilteredTriangle& placesOfA,
  const Triangle& b, const FilteredTriangle& placesOfB);
} // namespace insideout
