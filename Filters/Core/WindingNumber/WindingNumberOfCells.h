// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/ProgressRange.h"
#include "Common/TetrahedralMesh.h"

namespace insideout
{
/**
 * Whether the facets' signed sum is zero on every edge: each edge, counted with the multiplicities
 * and orientations of its facets, cancels. Then the winding number is an integer everywhere.
 */
bool IsClosed(const FacetComplex& surface);

/**
 * Stage w: the mean of the generalized winding number of the complex in each cell (thesis, chapter
 * 8).
 *
 * - Closed: carried from cell to cell. Entering a cell through a face adds the multiplicity there,
 *   so that every value is an exact integer.
 * - Open: caps close the holes (ExactWindingNumber.h). The integer part is carried from cell to
 *   cell as before, and evaluated exactly in the cells that a cap touches; the winding number of
 *   the caps is added at the barycenter, or integrated (TetrahedronQuadrature.h). Together they are
 *   smooth within a cell. Values are never off by one, with an error of about 1e-14.
 * - Facets that the mesh lost or the resolver left out count all the same. The cells that such a
 *   facet touches, and one cell of each part of the mesh that these cut off, are evaluated, and all
 *   others walked. On a closed complex values are integers. In a cell that such a facet crosses
 *   they may be a mean of the integers around a barycenter that lies on it.
 *
 * The values do not depend on the number of threads.
 *
 * @param[in] surface the complex that `mesh` was made of
 * @param[in] quadratureOrder degree up to which polynomials are integrated exactly, 1 to 5. Next to
 * an open edge the winding number depends on the direction from the edge, and high order gains
 * little there. It costs nothing on a closed complex.
 * @return one value per cell
 * @throws Error (Stopped), (InvalidParameter), (Inconsistent) when two ways to a cell give
 * different integers
 */
std::vector<double> WindingNumberOfCells(const FacetComplex& surface, const TetrahedralMesh& mesh,
  Monitor& monitor, int quadratureOrder = 1);

/**
 * The same mean in other cells, such as those of a refined mesh: the winding number of the mesh's
 * faces and of the facets beyond it. Facets may cross these cells.
 *
 * @param[in] mesh made of `surface`
 * @param[in] points, cells of positive volume
 * @return one value per cell
 * @throws Error (Stopped), (InvalidParameter)
 */
std::vector<double> WindingNumberOfOtherCells(const FacetComplex& surface,
  const TetrahedralMesh& mesh, const std::vector<Point>& points,
  const std::vector<Tetrahedron>& cells, int quadratureOrder, Monitor& monitor,
  const ProgressRange& progress);

/**
 * Sum of w times volume over the cells: negative where the surface is inside out as a whole. One
 * value of w per cell; summed with compensation, in the order of the cells.
 */
double SignedContent(const TetrahedralMesh& mesh, const std::vector<double>& w);
} // namespace insideout
