// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Orient/SampleRegions.h"

namespace insideout
{
/** Whether a shell counts beside the others. */
enum class ShellRole : char
{
  Counts,
  Membrane ///< does not count: attached to the solid of closed shells, across it or within it
};

/**
 * Find the shells that do not count: sheets that bound nothing, attached to a solid, across it or
 * within it.
 *
 * Sheets that are not altogether outside, and loose shells (LoosePatches.h), are held against the
 * solid of closed shells. A shell does not count if it lies in that solid. Nor does it if its part
 * outside seals off no space: the caps of its holes, as far as they are outside, have more than
 * `LargestCaps` of its area there. A dome or a chimney on the solid counts, for the solid closes
 * its foot.
 *
 * Sheets mostly outside that bound space together with other open shells count, too, such as walls
 * that stand in a slab: their winding number on the sheet, the mean of both sides, differs from 0
 * by `LeastWinding` on the average. Sheets for which it does not are taken away, until those that
 * are left support each other.
 *
 * Areas and means are found at random places, the same for any number of threads. All shells count
 * if none is closed.
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
