// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FaceTable.h"
#include "Common/TetrahedralMesh.h"

namespace insideout
{
/**
 * Find each constraint among the faces of the mesh, as a union of marked faces or whole, and set
 * Facets and FacetSides. Pieces have precedence. Next to a point that rounding moved off the facet,
 * the whole facet may by chance be a face as well. Its neighbors, which are split there, would not
 * match. A facet that is found neither way goes to LostFacets, and no face carries it. The Steiner
 * points on facets are counted and get their Origins, from the lowest facet that has them.
 *
 * @param[in] markedFaces faces reported as pieces of facets; the facet of one that is no face of
 * the mesh is lost
 * @param[in] facetOfMarkedFaces one per marked face
 * @param[in,out] mesh with Points, Cells and Origins of the complex's points
 */
void PlaceFacets(const FacetComplex& surface, const FaceTable& faces,
  const std::vector<Triangle>& markedFaces, const std::vector<Id>& facetOfMarkedFaces,
  TetrahedralMesh& mesh);
} // namespace insideout
