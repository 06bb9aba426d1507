// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "Common/Monitor.h"

#include <optional>

namespace insideout
{
/** The volumes of the places around which a surface winds at least once, and at least twice. */
struct WindingVolumes
{
  double Once = 0;
  double Twice = 0;
};

/**
 * The volumes within a closed surface, to some units in the last place: sums over the facets where
 * the winding number passes 1, and 2 (divergence theorem). The first is the volume of the solid
 * that the cut gives with weights that IsCutByWholeNumbers (CutEnergy.h) is true for.
 *
 * @param[in] surface resolved
 * @return nothing where the surface is open, or a facet was left out in resolving
 * @throws Error (Stopped)
 */
std::optional<WindingVolumes> VolumesWithin(const FacetComplex& surface, Monitor& monitor);
} // namespace insideout
