// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "Common/Monitor.h"

#include <optional>

namespace insideout
{
/** The volumes where the winding number of a surface is at least 1, and at least 2. */
struct WindingVolumes
{
  double Once = 0;
  double Twice = 0;
};

/**
 * Find the volumes within a closed surface, to some units in the last place: sums over the facets
 * at which the winding number passes 1, and 2 (divergence theorem). The first is the volume of the
 * solid that the cut gives with weights for which IsCutByWholeNumbers (RealEnergy.h) is true.
 *
 * @param[in] surface resolved
 * @return nothing if the surface is open, or a facet was left out in resolving
 * @throws Error (Stopped), or as PatchBoundary does
 */
std::optional<WindingVolumes> VolumesWithin(const FacetComplex& surface, Monitor& monitor);
} // namespace insideout
