// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/ProgressRange.h"
#include "Refine/RefinableSurface.h"
#include "Refine/SurfaceBound.h"

namespace insideout
{
/**
 * Contract the edges of a surface that are shorter than a tolerance and far shorter than the
 * adjacent triangles, together with the ridges that they separate. Otherwise a step of a millionth,
 * as CAD produces, would stay and require triangles as small as itself along its whole length. The
 * points that others were contracted into are Fixed afterwards: ridges have to be found anew.
 *
 * @return the number of contracted edges
 * @throws Error Stopped
 */
Id ContractSmallSteps(RefinableMesh& mesh, RefinableSurface& surface, SurfaceBound& bound,
  double tolerance, Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
