// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Refine/RefinableSurface.h"
#include "Refine/SizingField.h"
#include "Refine/SurfacePiece.h"

#include <vector>

namespace insideout
{
/**
 * Replace all cells of a mesh by those of a constrained Delaunay tetrahedralization of a surface
 * (TetrahedralizeExactly). A cell's region is the one that the pieces around it have on its side.
 *
 * @param[in,out] mesh keeps its points and gets the Steiner points of the cells
 * @param[in] pieces of the surface, whose facets tell the regions on both sides
 * @param[in] regions per cell of the input; empty: all are one
 * @param[in,out] sizes has no lengths given at points, which inner points would lose
 * @return false if the cells would not have all pieces as faces, or if regions contradict each
 * other; the mesh is unchanged then
 * @throws Error Stopped
 */
bool FillBetweenPieces(RefinableMesh& mesh, const std::vector<SurfacePiece>& pieces,
  const std::vector<FacetOfInput>& facets, const std::vector<Id>& regions, SizingField& sizes,
  Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
