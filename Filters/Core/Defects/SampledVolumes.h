// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "Common/Monitor.h"
#include "Common/ProgressRange.h"

namespace insideout
{
/** A volume, and the bounds that it is between in 95 of 100 cases. */
struct VolumeInterval
{
  double Value = 0;
  double Low = 0;
  double High = 0;

  bool IsExact() const { return this->Low == this->High; }
};

/** Where w is above 1/2, and above 3/2. */
struct SampledVolumes
{
  VolumeInterval Solid;
  VolumeInterval Overlap;
};

/**
 * The volumes that a surface encloses, by its winding number at places of several grids, each at
 * random in its box (randomized quasi-Monte Carlo: Owen, Monte Carlo Theory, Methods and
 * Examples, 2013, chapter 17). Facets may cross, and the surface may be open.
 *
 * Each grid gives an estimate without bias. The interval has the standard error of their mean, and
 * the places that the cut may decide otherwise than w above 1/2 does: those where w is near to 1/2,
 * and from where a way on which w is so leads to places on the other side of 1/2, through a hole.
 *
 * @param[in] surface whose coordinates are below 1, not all of it in one plane; every facet counts
 * @return the same for any number of threads
 * @throws Error (Stopped)
 */
SampledVolumes SampleVolumes(
  const FacetComplex& surface, Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
