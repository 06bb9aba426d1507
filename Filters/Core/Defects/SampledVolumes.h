// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "Common/Monitor.h"
#include "Common/ProgressRange.h"

namespace insideout
{
/** A volume, and bounds that hold it in 95 of 100 cases. */
struct VolumeInterval
{
  double Value = 0;
  double Low = 0;
  double High = 0;

  bool IsExact() const { return this->Low == this->High; }
};

/** The volumes where w is above 1/2, and above 3/2. */
struct SampledVolumes
{
  VolumeInterval Solid;
  VolumeInterval Overlap;
};

/**
 * Estimate the volumes that a surface encloses from its winding number at points of several grids,
 * one at random in each box (randomized quasi-Monte Carlo: Owen, Monte Carlo Theory, Methods and
 * Examples, 2013, chapter 17). Facets may cross, and the surface may be open.
 *
 * Each grid gives an unbiased estimate. The interval covers the standard error of their mean, and
 * the points at which the cut may decide otherwise than w > 1/2: those with w near 1/2 that a path
 * through a hole, along which w stays near 1/2, connects with points on the other side of 1/2.
 *
 * @param[in] surface whose coordinates are below 1, not all of it in one plane; every facet counts
 * @return the same for any number of threads
 * @throws Error (Stopped)
 */
SampledVolumes SampleVolumes(
  const FacetComplex& surface, Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
