// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Refine/RefinableMesh.h"
#include "Refine/RefinableSurface.h"
#include "Refine/SizingField.h"

namespace insideout
{
/** Take points that are on no facet out where they are much closer to others than edges are to be.
 */
void ThinPoints(RefinableMesh& mesh);

/**
 * Delaunay refinement by lengths. Where one length is asked for, and the surface is remeshed to it,
 * insert points of a lattice. Then
 * insert the circumcenter of each cell whose circumsphere is too large for the lengths there,
 * unless a facet is between or other points are close.
 *
 * @throws Error Stopped
 */
void FillWithPoints(RefinableMesh& mesh, SizingField& sizes, double maximumVolume,
  SurfaceTreatment surface, Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
