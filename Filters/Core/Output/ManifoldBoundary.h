// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Output/InsideBoundary.h"
#include "Output/PartedSolid.h"

namespace insideout
{
/** The boundary as a manifold: a surface with possibly several coincident points. */
struct ManifoldSurface
{
  std::vector<Triangle> Triangles; ///< the faces, in their order, by the points below
  std::vector<Id> Places;          ///< the solid's point at each point's place
  Id SharedPoints =
    /// copies within shared cells: the number of points minus that of distinct positions
    0;
  Id LeftEdges = 0; ///< edges with more than two triangles
};

/**
 * The boundary of a solid with separated points (PartPoints), as a 2-manifold: every edge has two
 * triangles, and those at every point are one fan. Only points are duplicated, in place.
 *
 * Separating the cells' points leaves some non-manifold points: cells around such a point are
 * connected through faces, and surround a space that they do not fill. Examples are two cavities
 * that touch in a point, and an edge with two fans of cells that are connected at both of its ends.
 * There only the surface gets copies, which the cells share; separating the cells, too, would
 * require a crack through the solid, or a new, rounded point (Attene et al. 2009 split such an
 * edge).
 *
 * At an edge with more than two faces, faces that bound the same space outside the solid are
 * joined. This separates the edge's ends, as follows. Let the cells at one of them be connected,
 * and draw them on a small sphere around it. Two fans at the edge are then regions that touch in a
 * point of the sphere, and are connected elsewhere; a closed curve through both, within the cells
 * but for that point, separates the spaces between them (Jordan). So each space is surrounded by a
 * fan of faces of its own, and each copy of the edge has its own ends and two faces.
 *
 * Where overlaps were separated, the space that a face bounds may be undefined. Then faces of the
 * same cells are joined, and the edge may keep more than two triangles.
 *
 * @param[in] solid with all points separated
 * @param[in] faces of its boundary (BoundaryFaces)
 * @throws Error Stopped
 */
ManifoldSurface ManifoldBoundary(const PartedSolid& solid, const std::vector<BoundaryFace>& faces,
  Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
