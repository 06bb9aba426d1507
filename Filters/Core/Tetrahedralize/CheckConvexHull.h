// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/TetrahedralMesh.h"

namespace insideout
{
/**
 * Prove that cells fill the convex hull of their points exactly once: their boundary has to be that
 * of a convex body. The cells must be positively oriented and lie on different sides of each face
 * that two of them share.
 *
 * Exact predicates test the boundary alone, in time that grows with its faces and not with the
 * cells: each edge has two faces, turned alike, and is convex; each point has one ring of faces;
 * the Euler characteristic is 2; exactly one point is the largest in lexicographic order among its
 * neighbors, and its ring goes round once. That suffices: let k(v) be the number of turns of the
 * ring of v. The normals of a surface with convex edges cover the sphere d = 1 + sum (k(v)
 * - 1) / 2 times, by the theorem of Gauss and Bonnet. Each point that is the largest in a general
 * direction counts k times in d. So d and every k are 1, and a surface that is convex at every
 * point is the boundary of a convex body.
 *
 * A Steiner point on the hull is rounded: at edges with such a point, a dent of 1e-12 of the mesh's
 * size passes.
 *
 * @param[in] inputPoints points from here on are Steiner points
 * @throws Error Inconsistent
 */
void CheckConvexHull(const TetrahedralMesh& mesh, std::size_t inputPoints);
} // namespace insideout
