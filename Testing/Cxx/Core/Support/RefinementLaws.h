// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Refine/RefineTetrahedra.h"

#include <functional>
#include <vector>

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

/**
 * Expect what it promises of a surface that is split: the points that were on it are there; every
 * face of the boundary or between regions is a piece of the one it says, and these make it up,
 * within rounding; no two of the boundary cross; regions keep their volumes.
 */
void ExpectSplitLaws(const insideout::TetrahedralMesh& mesh,
  const std::vector<insideout::Id>& regions, const insideout::RefinedMesh& refined);

/**
 * Expect what it promises of a surface that is remeshed: it is connected as before, crosses
 * nothing, and samples of each surface are no farther from the other than the tolerance.
 */
void ExpectRemeshingLaws(const insideout::TetrahedralMesh& mesh,
  const std::vector<insideout::Id>& regions, const insideout::RefinedMesh& refined,
  double tolerance);

/** The fraction of edges on no face of the boundary that have the length wanted at their midpoint,
 * up to a factor of 1.4. */
double ShareOfGoodEdges(const insideout::RefinedMesh& refined,
  const std::function<double(const insideout::Point&)>& wanted);

/** The sines of the least dihedral angles of cells, ascending. */
std::vector<double> LeastSines(
  const std::vector<insideout::Point>& points, const std::vector<insideout::Tetrahedron>& cells);
} // namespace testmeshes
