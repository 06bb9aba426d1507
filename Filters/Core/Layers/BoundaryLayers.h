// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Layers/LayerParameters.h"
#include "Layers/LayeredMesh.h"

#include <array>
#include <vector>

namespace insideout
{
/**
 * Layers of prisms inside a part of the boundary, whose triangles stay bit by bit. At each point of
 * the wall all layers shrink by the same factor where room is missing: in gaps and where the wall
 * is bent. Beside faces between regions and beside the rest of the boundary they shrink to 0, so no
 * two layers meet. They continue along planar parts of that rest (Sides), whose triangles get
 * narrower in their plane. A prism that loses an edge is a pyramid, one that loses two a
 * tetrahedron. All other faces of the boundary and between regions stay.
 *
 * Every cell is positive at its corners, exactly (Orient), each inner face belongs to two cells,
 * and the cells fill the solid. The result is deterministic.
 *
 * Statistics: Layers, Prisms, Pyramids, LayerTetrahedra; WallTriangles, WallPoints, of these
 * ReducedPoints, whose layers are lower than asked for, and BarePoints without layers;
 * NarrowPoints, for which a gap is too narrow, and EndPoints, at which no direction leads inward
 * from all triangles along the planes beside them; FullHeightShare, the share of the area whose
 * three points have full height, and MeanHeightShare, the mean over its area of the share of the
 * height.
 *
 * @param[in] mesh of any solid, with cells of the quality and size wanted behind the layers
 * @param[in] regions one per cell; empty: all are one
 * @param[in] wall faces without a second cell, 4 * cell + face, each once
 * @param[in] labels per face of each cell, one for each planar part of the boundary; empty: a
 * single one
 * @throws Error InvalidParameter, for parameters out of range, another number of regions, and a
 * wall face that does not exist, has a second cell or is repeated; TooLarge; Stopped
 */
LayeredMesh MakeBoundaryLayers(const TetrahedralMesh& mesh, const std::vector<Id>& regions,
  const std::vector<Id>& wall, const std::vector<std::array<Id, 4>>& labels,
  const LayerParameters& parameters, Monitor& monitor);
} // namespace insideout
