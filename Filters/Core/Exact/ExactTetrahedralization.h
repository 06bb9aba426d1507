// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/RawTetrahedra.h"

#include <cstdint>

namespace insideout
{
/** The result of TetrahedralizeExactly; AssembleMesh finds the lost facets. */
struct ExactTetrahedralization
{
  /** Cells of positive volume, exactly, that fill the convex hull. */
  RawTetrahedra Tetrahedra;

  /** The work on this mesh, the same on every machine (WorkBudget). */
  std::int64_t Work = 0;
};

/**
 * Tetrahedra of the convex hull of points in which every facet is a union of faces. All decisions
 * are exact and none depends on a tolerance. README.md beside this file describes the steps, and
 * why they end.
 *
 * It begins with the Delaunay tetrahedralization of the points. Missing edges of facets are
 * recovered by pulls and flips (PullVertex.h, Flips.h), then the facets between them. Constraints
 * that flips do not recover are cut into the mesh by Steiner points that lie exactly on the facet
 * or segment; this always works. They are removed again, or moved into the volume, after each cut,
 * and once more after random flips around them. Those that remain on the surface are rounded to
 * doubles if exact tests allow it. Facets with points that cannot be rounded are released together
 * with their neighbors. Then these are recovered in another order, for as long as that takes no
 * more work than everything before.
 *
 * It terminates because work is limited. It is thread-safe and deterministic: the same input gives
 * the same mesh on every machine, because all limits are counts of work, not times.
 *
 * @param[in] points finite, spanning space. If several coincide, the first represents them
 * @param[in] facets ids in range; any two may meet only in shared points and edges, and no point
 * may lie within one of their edges. A facet that breaks this is lost
 * @param[in] monitor hears the phases by name (Phases.h), and a fraction that only grows
 * @param[in] workPerElement the work limit per point and facet (WorkBudget). When it is used up, no
 * more Steiner points are inserted, and missing facets are lost. The default is about 4 ms each:
 * one of 150 real surfaces took three tenths of it, the others at most a tenth
 * @throws Error Planar, Inconsistent, Stopped
 */
ExactTetrahedralization TetrahedralizeExactly(const std::vector<Point>& points,
  const std::vector<Triangle>& facets, Monitor& monitor, std::int64_t workPerElement = 100000);
} // namespace insideout
