// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Boolean/ResolveBodies.h"
#include "Common/ProgressRange.h"
#include "Common/TetrahedralMesh.h"

namespace insideout
{
/**
 * The winding number of each body in each cell of one mesh, the same as by WindingNumberOfCells for
 * the body alone: an exact integer if the body is closed, regardless of the others.
 *
 * @param[in] mesh made of bodies.Surface
 * @param[in] quadratureOrder 1 to 5, see WindingNumberOfCells
 * @return w of each body, one value per cell
 * @throws Error as WindingNumberOfCells does; Stopped
 */
std::vector<std::vector<double>> WindingNumbersOfBodies(
  const ResolvedBodies& bodies, const TetrahedralMesh& mesh, int quadratureOrder, Monitor& monitor);

/**
 * The same in other cells, such as those of a refined mesh (WindingNumberOfOtherCells), of the
 * bodies with a boundary; empty for the others.
 *
 * @param[in] points, cells of positive volume
 * @throws Error (Stopped), (InvalidParameter)
 */
std::vector<std::vector<double>> WindingNumbersOfOpenBodies(const ResolvedBodies& bodies,
  const TetrahedralMesh& mesh, const std::vector<Point>& points,
  const std::vector<Tetrahedron>& cells, int quadratureOrder, Monitor& monitor,
  const ProgressRange& progress);
} // namespace insideout
