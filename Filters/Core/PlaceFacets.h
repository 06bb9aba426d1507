// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "FaceTable.h"
#include "TetrahedralMesh.h"

namespace insideout
{
/**
 * Find each constraint among the faces of the mesh, whole or as a union of marked faces, and set
 * Facets and FacetSides. What is found neither way goes to LostFacets, and no face carries it. The
 * Steiner points on facets are counted and get their Origins, from the lowest facet that has them.
 *
 * @param[in] markedFaces faces that are said to be pieces of facets; one that is no face of the
 * mesh loses its facet
 * @param[in] facetOfMarkedFaces one per marked face
 * @param[in,out] mesh with Points, Cells and Origins of the complex's points
 */
void PlaceFacets(const FacetComplex& surface, const FaceTable& faces,
  const std::vector<Triangle>& markedFaces, const std::vector<Id>& facetOfMarkedFaces,
  TetrahedralMesh& mesh);
} // namespace insideout
