// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Refine/RefinableSurface.h"
#include "Refine/SizingField.h"
#include "Refine/SurfaceBound.h"

namespace insideout
{
/**
 * Make the edges of facets as long as they are to be, as far as the surface may change (Botsch and
 * Kobbelt 2004, A Remeshing Approach to Multiresolution Modeling): split long ones; where it is
 * remeshed contract short ones and move points along it; turn diagonals for better triangles. All
 * cells stay positive.
 *
 * @throws Error Stopped
 */
void RemeshSurface(RefinableMesh& mesh, RefinableSurface& surface, SurfaceBound& bound,
  SizingField& sizes, Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
