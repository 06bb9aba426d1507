// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/ProgressRange.h"
#include "Orient/SurfacePatches.h"

namespace insideout
{
/** Winding numbers just beside a patch, at a facet of it: before it is where its normals point. */
struct PatchSides
{
  double Front;
  double Back;
};

/**
 * The winding number just beside both sides of each patch, without any mesh: one exact query in the
 * middle of the patch's largest facet gives the mean of both sides, and how often the facet counts
 * their difference. On a closed surface these are whole numbers, the same all along the patch; on
 * an open one they are those at that facet. From them follows what any set operation keeps (Zhou,
 * Grinspun, Zorin and Jacobson 2016).
 *
 * @param[in] surface resolved: its facets meet in shared points and edges only
 * @param[in] patches of the surface
 * @return one per patch
 * @throws Error (Stopped)
 */
std::vector<PatchSides> WindingNumbersBesidePatches(const FacetComplex& surface,
  const SurfacePatches& patches, Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
