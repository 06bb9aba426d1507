// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "Common/Monitor.h"

namespace insideout
{
/**
 * The parts of a surface that may be tetrahedralized apart: facets connected by points, joined
 * until no two bounding boxes meet. Then no convex hull meets another part, and a part that is
 * closed has a winding number of 0 beyond its own.
 *
 * This does not hold for open surfaces: a solid may reach from one open piece to another, so all
 * open pieces belong to one part. Planar pieces belong to it too, because they have no volume to
 * fill. If all of these are planar, the first piece that is neither open nor planar joins them.
 *
 * @param[in] surface resolved, of valid ids and finite points
 * @return one part per point, numbered from 0 by their lowest points
 * @throws Error Stopped
 */
std::vector<Id> PartsApart(const FacetComplex& surface, Monitor& monitor);
} // namespace insideout
