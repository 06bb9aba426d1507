// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/ExactState.h"

namespace insideout
{
/**
 * Move a vertex to another place and reconnect it as if it were removed and inserted (Bowyer 1981,
 * Watson 1981, with visibility in the place of empty spheres): the cells around it give way, then
 * each cell behind a face that does not see the new place. New cells join the vertex with the
 * boundary of their union. All other vertices, facets and segments stay.
 * @return whether it is there; else the mesh is as before
 */
bool MovePoint(ExactState& state, Id point, const Point& place);

/**
 * Put a vertex that lies on no facet, segment or face of the hull out of the mesh; what was
 * connected with it, and what is in the way, is connected with a neighbor of it.
 * @return whether it is gone; else the mesh is as before
 */
bool CollapsePoint(ExactState& state, Id point, Id neighbor);
} // namespace insideout
