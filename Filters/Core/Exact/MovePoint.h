// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/ExactState.h"

namespace insideout
{
/**
 * Move a vertex and reconnect it as if it were removed and inserted (Bowyer 1981, Watson 1981, with
 * visibility instead of empty spheres): the cavity consists of the cells around it and of each cell
 * behind a face that does not see the new position. New cells join the vertex with the boundary of
 * their union. All other vertices, facets and segments stay.
 * @return whether it was moved; else the mesh is as before
 */
bool MovePoint(ExactState& state, Id point, const Point& place);

/**
 * Remove a vertex that lies on no facet, segment or face of the hull, by collapsing it and the
 * obstacles onto the first of some neighbors that allows it.
 * @return whether it was removed; else the mesh is as before
 */
bool CollapsePoint(ExactState& state, Id point, const std::vector<Id>& neighbors);
} // namespace insideout
