// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Boolean/ResolveBodies.h"
#include "Common/TetrahedralMesh.h"

namespace insideout
{
/**
 * The winding number of each body in each cell of one mesh, as WindingNumberOfCells has it of a
 * body alone: an exact integer where the body is closed, whatever the others are like.
 *
 * @param[in] mesh made of bodies.Surface
 * @param[in] quadratureOrder 1 to 5, see WindingNumberOfCells
 * @return w of each body, one value per cell
 * @throws Error whatever WindingNumberOfCells throws; Stopped
 */
std::vector<std::vector<double>> WindingNumbersOfBodies(
  const ResolvedBodies& bodies, const TetrahedralMesh& mesh, int quadratureOrder, Monitor& monitor);
} // namespace insideout
