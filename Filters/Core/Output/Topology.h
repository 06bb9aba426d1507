// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Statistics.h"
#include "Output/InsideBoundary.h"

namespace insideout
{
/** The Betti numbers of a closed set. */
struct BettiNumbers
{
  Id Components = 0; ///< number of connected components
  /// independent loops that do not shrink to a point: one for a ring, two for its boundary
  Id Tunnels = 0;
  Id Cavities = 0; ///< bounded components of the complement

  Id EulerCharacteristic() const { return this->Components - this->Tunnels + this->Cavities; }
};

/** Betti numbers of a solid of tetrahedra, and of its boundary. */
struct SolidTopology
{
  BettiNumbers Solid;
  BettiNumbers Boundary;
};

/**
 * The Betti numbers of the union of the inside cells and of the union of its boundary faces, each
 * with its edges and points; so cells that touch in one point are one component. The number of
 * tunnels follows from Euler's formula, the number of cavities from the parts of the outside
 * (Alexander's duality).
 *
 * @param[in] mesh of a convex hull, so that all of the outside is known
 * @param[in] inside one label per cell, not 0 for those inside
 * @param[in] boundary of it
 * @throws Error InvalidParameter if there is not one label per cell; Stopped
 */
SolidTopology FindTopology(const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside,
  const std::vector<BoundaryFace>& boundary, Monitor& monitor, const ProgressRange& progress);

/**
 * The same for conforming tetrahedra, from their boundary alone. It bounds the regions and all but
 * one of the components of the outside, so the number of independent closed surfaces, modulo 2, is
 * that of regions and cavities.
 *
 * @param[in] points their number
 * @param[in] boundary the faces of one cell only
 * @param[in] regions the number of components of cells connected through faces
 */
SolidTopology FindTopology(std::size_t points, const std::vector<Tetrahedron>& cells,
  const std::vector<Triangle>& boundary, Id regions);

/** As statistics: Components, Tunnels, Cavities, EulerCharacteristic, and the same of the boundary
 * prefixed with Boundary. Genus is half of the boundary's tunnels: its handles, if it is a
 * manifold. */
void AppendTopology(const SolidTopology& topology, Statistics& statistics);
} // namespace insideout
