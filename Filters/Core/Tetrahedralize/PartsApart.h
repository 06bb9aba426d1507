// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "Common/Monitor.h"

namespace insideout
{
/**
 * The parts of a surface that may be tetrahedralized apart: facets that points join, and with them
 * all that has a box which meets theirs, until no two boxes meet. Then no convex hull meets another
 * part, and a part that is closed has a winding number of 0 beyond its own.
 *
 * An open surface has not, and a solid may reach from one open piece to another: all open pieces
 * are of one part, wherever they are. So are those that lie in a plane, for they have no volume to
 * fill; where all of these do, the first piece that neither is open nor does joins them.
 *
 * @param[in] surface resolved, of valid ids and finite points
 * @return one part per point, numbered from 0 by their lowest points
 * @throws Error Stopped
 */
std::vector<Id> PartsApart(const FacetComplex& surface, Monitor& monitor);
} // namespace insideout
