// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Orient/SampleRegions.h"

namespace insideout
{
/** What a shell is beside the others. */
enum class ShellRole : char
{
  Counts,
  Membrane ///< does not count: attached to the solid of closed shells, across it or within it
};

/**
 * Which shells do not count: sheets that bound nothing, attached to a solid, across it or within
 * it.
 *
 * Sheets that are not altogether outside, and shells that are loose (LoosePatches.h), are held
 * against the solid of closed shells. These do not count:
 *
 *   1. those that lie in that solid, and
 *   2. those whose part outside it seals off no space: the caps of its holes, where they are
 * outside too, have more than `LargestCaps` of its area. A dome or a chimney that stands on the
 * solid is none, for the solid closes its foot. Nor is
 *   3. a sheet that lies mostly outside and bounds space together with other open shells, as walls
 *      that stand in a slab: on the average their winding number has to differ by `LeastWinding`
 *      from the 0 that it is on a lone flat one, the mean of both sides. Sheets for which it does
 *      not are taken away, until those that are left support each other.
 *
 * Areas and means are found at random places, the same for any number of threads. Where no
 * shell is closed all count.
 *
 * @param[in] points those of the surface, scaled as for the sampler
 * @param[in] turned one per shell
 * @return one per shell
 * @throws Error (Stopped)
 */
std::vector<ShellRole> FindMembranes(const std::vector<Point>& points,
  const std::vector<ShellChain>& chains, const std::vector<char>& turned,
  const RegionSampler& sampler, Monitor& monitor);
} // namespace insideout
