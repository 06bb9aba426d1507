// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/TetrahedralMesh.h"
#include "Refine/RefinableSurface.h"

#include <vector>

namespace insideout
{
/** @throws Error InvalidParameter, which names a cell without volume, or two that overlap at a face
 */
void CheckCells(const TetrahedralMesh& mesh);

/**
 * The faces on the boundary and between regions, in the order of their first cells.
 *
 * @param[in] regions one per cell; empty: all are one
 * @param[in] labels per face of each cell; empty: all are one. A facet's label depends on the given
 * one and on the regions on its two sides.
 */
std::vector<FacetOfInput> FacetsOf(const TetrahedralMesh& mesh, const std::vector<Id>& regions,
  const std::vector<std::array<Id, 4>>& labels);

/** Make the faces that facets name, 4 * cell + face, pieces of these. */
void SetFacets(const std::vector<FacetOfInput>& facets, RefinableMesh& mesh);

/** The mesh with its facets. */
RefinableMesh MakeRefinable(const TetrahedralMesh& mesh, const std::vector<Id>& regions,
  const std::vector<FacetOfInput>& facets);
} // namespace insideout
