// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/TetrahedralMesh.h"
#include "WindingNumber/CountedBoundary.h"

namespace insideout
{
/**
 * Winding numbers carried from the hull into every cell: entering a cell through a face adds the
 * multiplicity there, and nothing else if the complex is closed and its facets are all in the mesh.
 *
 * @return one whole number per cell
 * @throws Error (Stopped), (Inconsistent) when two ways to a cell give different numbers or there
 * is none
 */
std::vector<double> WalkedWindingNumbers(
  const FacetComplex& surface, const TetrahedralMesh& mesh, Monitor& monitor);

/** The count of every face of the mesh, from the facets that the mesh has whole. */
class FaceCounts
{
public:
  /** @param[in] surface, mesh of which the facets that the mesh lost count nothing; both have to
   * live as long as this object */
  FaceCounts(const FacetComplex& surface, const TetrahedralMesh& mesh);

  /** The jump of w when entering the cell through the face; 0 for pieces of lost facets. */
  int OnEntering(Id cell, int face) const
  {
    const Id facet = this->Mesh.Facets[cell][face];
    return facet == None ? 0 : this->Mesh.FacetSides[cell][face] * this->Count[facet];
  }

  /** The faces with a count, each once, along the outward normal of one of its cells. */
  ChainOfFacets Chain() const;

  /** Set to 0 the count of faces of facets whose flag in `facets`, one per facet, is not 0. */
  void LeaveOut(const std::vector<char>& facets);

private:
  const TetrahedralMesh& Mesh;
  std::vector<int> Count; // per facet
};

/** Parts of the mesh: untouched cells connected through faces. */
struct UntouchedParts
{
  struct Place
  {
    Id Part;  ///< None for touched cells
    int Rise; ///< relative to the part's first cell
  };

  std::vector<Place> OfCell;
  std::vector<Id> FirstCell; ///< of each part
};

/**
 * Walk within each part, from its first cell to all others.
 *
 * @param[in] touched one flag per cell, not 0 for cells that belong to no part
 * @throws Error (Inconsistent) when two ways to a cell give different numbers
 */
UntouchedParts WalkParts(
  const FaceCounts& counts, const TetrahedralMesh& mesh, const std::vector<char>& touched);
} // namespace insideout
