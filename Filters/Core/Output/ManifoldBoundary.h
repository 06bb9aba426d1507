// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Output/InsideBoundary.h"
#include "Output/PartedSolid.h"

namespace insideout
{
/** The boundary as a manifold: a surface whose points may stand in one place several times. */
struct ManifoldSurface
{
  std::vector<Triangle> Triangles; ///< the faces, in their order, by the points below
  std::vector<Id> Places;          ///< the solid's point where each point stands
  Id SharedPoints =
    0;              ///< copies that cells share: the number of points beyond the number of places
  Id LeftEdges = 0; ///< edges with more than two triangles
};

/**
 * The boundary of a solid whose points are parted (PartPoints), as a 2-manifold: every edge has two
 * triangles, those at every point are one fan. Only points are duplicated, in their place.
 *
 * Parting the cells' points leaves what no copy of a cell's point can part: cells around a point
 * are connected through faces, and go around something that they do not fill. Two cavities that
 * touch in a point are an example, and an edge whose cells are two fans at both of whose ends these
 * are connected. There the surface alone gets copies, which the cells share; to part the cells,
 * too, would take a crack through the solid, or a new point, which is rounded (Attene et al. 2009
 * put one amid such an edge).
 *
 * At an edge with more than two faces those are joined that bound the same space outside the solid.
 * That parts the edge's ends: let the cells at one of them be connected, and draw them on a small
 * sphere around it. Two fans at the edge are then regions that touch in a point of the sphere, and
 * are connected elsewhere; a closed curve through both, within the cells but for that point, parts
 * the spaces between them (Jordan), so that each space is walked round by another fan of faces. So
 * each copy of the edge has other ends than the others, and two faces.
 *
 * Where overlaps were separated there may be nothing that tells which space a face bounds. Then
 * faces of the same cells are joined, and the edge may keep more than two triangles.
 *
 * @param[in] solid all of whose points are parted
 * @param[in] faces of its boundary (BoundaryFaces)
 * @throws Error Stopped
 */
ManifoldSurface ManifoldBoundary(const PartedSolid& solid, const std::vector<BoundaryFace>& faces,
  Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
