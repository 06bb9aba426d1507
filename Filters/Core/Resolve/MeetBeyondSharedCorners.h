// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <vector>

namespace insideout
{
/**
 * Whether two triangles meet in more than the corners, and the edge between them, that they share
 * by id. Equal coordinates under two ids do not make a shared corner. The three ids must not all
 * agree.
 */
bool MeetBeyondSharedCorners(
  const std::vector<Point>& points, const Triangle& a, const Triangle& b);

/** The same, for triangles given by ids and coordinates. */
bool MeetBeyondSharedCorners(const Triangle& a, const std::array<Point, 3>& placesOfA,
  const Triangle& b, const std::array<Point, 3>& placesOfB);
} // namespace insideout
