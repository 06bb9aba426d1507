// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Refine/RefinableSurface.h"
#include "Refine/SizingField.h"
#include "Refine/SurfaceBound.h"

#include <vector>

namespace insideout
{
/**
 * Remesh a surface to the sizes at its points: split long edges, contract short ones, flip
 * diagonals and move points, in several rounds (Botsch, Kobbelt 2004, A Remeshing Approach to
 * Multiresolution Modeling). SurfaceBound decides about each step. The cells do not follow:
 * FillBetweenPieces makes others.
 *
 * @param[in] tolerance of the surface: a few times this is the least length
 * @param[in,out] mesh gets points and sizes; its cells stay as they are
 * @return the pieces
 * @throws Error Stopped
 */
std::vector<SurfacePiece> RemeshPieces(RefinableMesh& mesh, RefinableSurface& surface,
  SurfaceBound& bound, SizingField& sizes, double tolerance, Monitor& monitor,
  const ProgressRange& progress);
} // namespace insideout
