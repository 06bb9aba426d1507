// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Orient/SampleRegions.h"

namespace insideout
{
/** Whether a shell counts beside the others. */
enum class ShellRole : char
{
  Counts,
  Membrane, ///< does not count: a sheet within the solid, or across it
  Sheet     ///< does not count: mostly outside, where it seals off no space
};

/**
 * Find the shells that do not count: sheets that seal off no space.
 *
 * Sheets, and loose shells (LoosePatches.h), are held against the other shells. One within closed
 * shells does not count. Where it is outside of these, the mean winding number along it decides,
 * half way between its two sides. One that shells with holes wind around by more than `MostInside`
 * does not count: it is within them, and 1/2 is on their caps, where a lid lies. The others are
 * looked at together: the *seal* of each is the mean of shells with holes, of all the others and of
 * what the solid closes of their caps. A flat sheet alone has a seal of 0, a dome on a body 1/2.
 * The one with the lowest seal goes, if that is below `LeastSeal`, and the others are judged
 * without it.
 *
 * Means are those over random lines, the same for any number of threads. All shells count if there
 * is no solid.
 *
 * @param[in] points those of the surface, scaled as for the sampler
 * @param[in] turned one per shell
 * @return one per shell
 */
std::vector<ShellRole> FindMembranes(const std::vector<Point>& points,
  const std::vector<ShellChain>& chains, const std::vector<char>& turned,
  const RegionSampler& sampler);
} // namespace insideout
