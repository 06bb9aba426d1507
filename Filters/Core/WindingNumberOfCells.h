// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Monitor.h"
#include "TetrahedralMesh.h"

namespace insideout
{
/**
 * Whether the facets' signed sum is zero on every edge: each edge, counted with the multiplicities
 * and orientations of its facets, cancels. Then the winding number is an integer everywhere.
 */
bool IsClosed(const FacetComplex& surface);

/**
 * Stage w: the generalized winding number of the complex in each cell (thesis, chapter 8).
 *
 * On a closed complex it is carried from cell to cell: entering a cell through a face adds the
 * multiplicity there, so that every value is an exact integer. On an open complex, or one with
 * facets that the mesh lost or the resolver left out, it is the sum of the solid angles at the
 * cell's barycentre (WindingNumberSum.h), where on which side of a facet the barycentre lies is
 * decided exactly; if the complex is closed nevertheless, values are rounded to the integer that
 * they stand for, or to the half where a barycentre lies on a lost facet.
 *
 * @param[in] surface the complex that `mesh` was made of
 * @return one value per cell
 * @throws Error (Stopped), (Inconsistent) when two ways to a cell give different integers
 */
std::vector<double> WindingNumberOfCells(
  const FacetComplex& surface, const TetrahedralMesh& mesh, Monitor& monitor);

/**
 * Sum of w times volume over the cells: negative where the surface is inside out as a whole. One
 * value of w per cell; summed with compensation, in the order of the cells.
 */
double SignedContent(const TetrahedralMesh& mesh, const std::vector<double>& w);
} // namespace insideout
