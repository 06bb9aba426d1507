// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/ProgressRange.h"
#include "Refine/RefinableSurface.h"
#include "Refine/SurfaceBound.h"

namespace insideout
{
/**
 * Contract the edges of a surface that are shorter than a tolerance, and far shorter than the
 * triangles beside them, with the ridges that they part: a step of a millionth, as CAD leaves it,
 * would else have to stay, and ask for triangles as small as itself all along. The points that
 * others went into are Fixed after it: ridges are to be found anew.
 *
 * @throws Error Stopped
 */
void ContractSmallSteps(RefinableMesh& mesh, RefinableSurface& surface, SurfaceBound& bound,
  double tolerance, Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
