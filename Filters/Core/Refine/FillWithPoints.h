// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Refine/RefinableMesh.h"
#include "Refine/RefinableSurface.h"
#include "Refine/SizingField.h"

namespace insideout
{
/** Remove points on no facet that are much closer to others than the wanted edge length. */
void ThinPoints(RefinableMesh& mesh);

/**
 * Delaunay refinement by lengths. If one length is wanted and the surface is remeshed to it, insert
 * lattice points first. Then insert the circumcenter of each cell whose circumsphere is too large
 * for the lengths there, unless a facet is between or other points are close.
 *
 * @throws Error Stopped
 */
void FillWithPoints(RefinableMesh& mesh, SizingField& sizes, double maximumVolume,
  SurfaceTreatment surface, Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
