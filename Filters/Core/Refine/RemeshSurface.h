// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Refine/RefinableSurface.h"
#include "Refine/SizingField.h"
#include "Refine/SurfaceBound.h"

namespace insideout
{
/**
 * Give the edges of facets the required length, as far as the surface may change (Botsch and
 * Kobbelt 2004, A Remeshing Approach to Multiresolution Modeling). Split long edges; if it is
 * remeshed, contract short ones and move points along it; flip diagonals for better triangles. All
 * cells stay positive.
 *
 * @throws Error Stopped
 */
void RemeshSurface(RefinableMesh& mesh, RefinableSurface& surface, SurfaceBound& bound,
  SizingField& sizes, Monitor& monitor, const ProgressRange& progress);

/** Flip the edges within facets, as far as cells allow it, to Delaunay ones. @throws Error Stopped
 */
void TurnDiagonals(RefinableMesh& mesh, RefinableSurface& surface, SurfaceBound& bound,
  SizingField& sizes, Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
