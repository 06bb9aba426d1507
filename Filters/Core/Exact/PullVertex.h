// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/ExactState.h"

namespace insideout
{
/**
 * Connect a vertex with several others at once. The cells that the segments to them cross give way
 * to a cone from the vertex over the boundary of their union. Cells behind faces that do not see
 * the vertex belong to that union. Vertices, facets, segments and the hull stay; coplanar faces of
 * the hull may be triangulated another way.
 *
 * Points of CAD models are (nearly) cospherical: more than one mesh is (nearly) Delaunay. This
 * chooses the one with the facets: the pulling triangulation (Lee 1991).
 *
 * Others behind a facet or segment are passed over. The mesh stays as it is where the cone would
 * break a constraint, or add more than one cell per two segments: flips add one for each.
 * @return whether the vertex is connected with all others that were not passed over
 */
bool PullVertex(ExactState& state, Id apex, const std::vector<Id>& others);
} // namespace insideout
