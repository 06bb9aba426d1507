// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Orient/SampleRegions.h"

namespace insideout
{
/** Whether a shell counts beside the others. */
enum class ShellRole : char
{
  Counts,
  Membrane ///< does not count: within the solid of closed shells, or across it
};

/**
 * Find the shells that do not count: sheets that bound nothing, within a solid or across it.
 *
 * Sheets, and loose shells (LoosePatches.h), are held against the solid of closed shells. A shell
 * does not count if it lies in that solid, or if the lesser part of it that is outside seals off no
 * space: the caps of its holes, as far as they are outside, have more than `LargestCaps` of its
 * area there. A shell mostly outside counts: it may bound space with the solid or with other
 * sheets.
 *
 * Areas are found at random places, the same for any number of threads. All shells count if none is
 * closed.
 *
 * @param[in] points those of the surface, scaled as for the sampler
 * @param[in] turned one per shell
 * @return one per shell
 */
std::vector<ShellRole> FindMembranes(const std::vector<Point>& points,
  const std::vector<ShellChain>& chains, const std::vector<char>& turned,
  const RegionSampler& sampler);
} // namespace insideout
