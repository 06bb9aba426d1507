// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Orient/SampleRegions.h"

namespace insideout
{
/** The role of a shell relative to the others. */
enum class ShellRole : char
{
  Counts,
  Membrane, ///< does not count: a sheet within the solid, or across it
  Sheet     ///< does not count: mostly outside, where it seals off no space
};

/**
 * Find the shells that do not count: sheets that seal off no space.
 *
 * Sheets, and loose shells (LoosePatches.h), are compared with the other shells. A sheet within
 * closed shells does not count. Outside them, mean winding numbers along the sheet decide, averaged
 * over its two sides. A sheet does not count if the mean of shells with holes exceeds `MostInside`:
 * it is within them; on their caps, where a lid lies, it is 1/2. The *seal* of each other sheet is
 * the mean of shells with holes, of all the other sheets, and of the parts of their caps that lie
 * in the solid. A flat sheet alone has a seal of 0, a dome on a body 1/2. The sheet with the lowest
 * seal does not count if that is below `LeastSeal`; the others are judged without it.
 *
 * Means are taken over random lines, the same for any number of threads. All shells count if there
 * is no solid.
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
