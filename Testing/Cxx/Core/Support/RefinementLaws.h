// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Refine/RefineTetrahedra.h"

namespace testmeshes
{
/**
 * Expect what RefineTetrahedra promises: positive cells that conform, with exactly the faces
 * between regions and on the boundary that the input has, which together mean that the same solid
 * is filled; points that say what they were; cells that say where they are.
 * @param[in] regions as given to it
 */
void ExpectRefinementLaws(const insideout::TetrahedralMesh& mesh,
  const std::vector<insideout::Id>& regions, const insideout::RefinedMesh& refined);

/** The sines of the least dihedral angles of cells, ascending. */
std::vector<double> LeastSines(
  const std::vector<insideout::Point>& points, const std::vector<insideout::Tetrahedron>& cells);
} // namespace testmeshes
