// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"

namespace insideout
{
/**
 * A conforming tetrahedralization of the convex hull of a FacetComplex. Its points are the
 * complex's points in their order, then Steiner points. Every cell is positively oriented
 * (orient3d, exactly).
 */
struct TetrahedralMesh
{
  std::vector<Point> Points;
  std::vector<PointOrigin> Origins; ///< one per point
  std::vector<Tetrahedron> Cells;

  /** Cell across face k (TetrahedronFaces), None outside the hull. */
  std::vector<std::array<Id, 4>> Neighbors;

  /** Facet of the complex on face k, None for none. */
  std::vector<std::array<Id, 4>> Facets;

  /** +1 if that facet's normal leaves the cell through face k, -1 if it enters, 0 for no facet. */
  std::vector<std::array<std::int8_t, 4>> FacetSides;

  /** Constraints of the complex that are not a union of faces. Empty unless the tetrahedralizer
   * failed on them. */
  std::vector<Id> LostFacets;

  Id NumberOfSteinerPoints = 0;
  Id NumberOfSurfaceSteinerPoints = 0; ///< number of these on facets or their edges

  Id NumberOfCells() const { return static_cast<Id>(this->Cells.size()); }
};

/**
 * The jump of the winding number on entering cell `cell` through its face `face`: the multiplicity
 * of the facet there, along the cell's outward normal; 0 without a facet.
 */
inline int MultiplicityOnEntering(
  const FacetComplex& surface, const TetrahedralMesh& mesh, Id cell, int face)
{
  const Id facet = mesh.Facets[cell][face];
  return facet == None ? 0 : mesh.FacetSides[cell][face] * surface.Multiplicity[facet];
}
} // namespace insideout
