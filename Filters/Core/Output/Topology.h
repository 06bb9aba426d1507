// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Statistics.h"
#include "Output/InsideBoundary.h"

namespace insideout
{
/** How a closed set hangs together. */
struct BettiNumbers
{
  Id Components = 0; ///< that no point connects
  Id Tunnels = 0; ///< ways around that do not shrink to a point: of a ring one, of its boundary two
  Id Cavities = 0; ///< parts of space that it cuts off from beyond

  Id EulerCharacteristic() const { return this->Components - this->Tunnels + this->Cavities; }
};

/** Betti numbers of a solid of tetrahedra, and of its boundary. */
struct SolidTopology
{
  BettiNumbers Solid;
  BettiNumbers Boundary;
};

/**
 * The Betti numbers of the union of the inside cells and of that of its boundary faces, each with
 * its edges and points: so cells that touch in one point are one component. The number of tunnels
 * follows from Euler's formula, the number of cavities from the parts of the outside (Alexander's
 * duality).
 *
 * @param[in] mesh of a convex hull, so that all of the outside is known
 * @param[in] inside one label per cell, not 0 for those inside
 * @param[in] boundary of it
 * @throws Error InvalidParameter when there is not one label per cell; Stopped
 */
SolidTopology FindTopology(const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside,
  const std::vector<BoundaryFace>& boundary, Monitor& monitor, const ProgressRange& progress);

/**
 * The same of tetrahedra that fit together, from their boundary alone: it bounds the regions and,
 * but for one, the parts of the outside, so that it has as many closed surfaces, counted modulo 2,
 * as there are regions and cavities.
 *
 * @param[in] points how many there are
 * @param[in] boundary the faces that one cell alone has
 * @param[in] regions how many parts of the cells faces connect
 */
SolidTopology FindTopology(std::size_t points, const std::vector<Tetrahedron>& cells,
  const std::vector<Triangle>& boundary, Id regions);

/** As figures: Components, Tunnels, Cavities, EulerCharacteristic, and the same of the boundary
 * with Boundary before it. Genus is half of the boundary's tunnels, its handles where it is a
 * manifold. */
void AppendTopology(const SolidTopology& topology, Statistics& statistics);
} // namespace insideout
