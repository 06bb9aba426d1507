// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Boolean/Body.h"
#include "HullMesh.h"

namespace insideout
{
/** The convex hull of several bodies in tetrahedra, and each body's winding number in each. */
struct HullOfBodies
{
  HullMesh Whole;                     ///< of all together: its W is the sum over the bodies
  std::vector<std::vector<double>> W; ///< of each body, one per cell
};

/**
 * As MeshHull, for several bodies on one mesh: each is counted, turned the way that is meant and
 * thickened on its own (ResolveBodies), and has a winding number of its own. Counts are sums over
 * the bodies.
 *
 * @throws Error whatever the stages throw
 */
HullOfBodies MeshBodies(
  std::vector<Body> bodies, const HullMeshParameters& parameters, Monitor& monitor);
} // namespace insideout
