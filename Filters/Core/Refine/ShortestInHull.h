// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <vector>

namespace insideout
{
/** The point nearest to the origin in the convex hull of some vectors, by the method of Frank and
 * Wolfe (1956), within a thousandth. @param[in] steps limit of iterations
 */
Point ShortestInHull(const std::vector<Point>& vectors, int steps);
} // namespace insideout
