// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Orient/PatchSeams.h"

namespace insideout
{
/** Whether the signed sum of facets is 0 at all seams. */
bool AllSeamsBalance(const SeamedPatches& patches, const std::vector<char>& turned);

/**
 * Patches without which the others fit together: candidates for membranes.
 *
 * A patch is loose if the signed sum of facets at its seams is 0 without the loose patches, but not
 * with them. An example is a wall across a box, at whose edges the box's own facets balance. Either
 * such a wall or the part it cuts off can be the loose one: the one that encloses less, holes
 * capped, is chosen. Patches without seams are never loose.
 *
 * Patches are removed one by one, those that enclose least first, while this reduces the imbalance:
 * the sum of seam lengths times their signed sums. Then patches are restored if the others do not
 * balance at their seams.
 *
 * @param[in] turned one per patch: 1 if its facets are to be turned over
 * @param[in] volumes one per patch: the volume that it then encloses, holes capped
 * @return one per patch
 */
std::vector<char> FindLoosePatches(const SeamedPatches& patches, const std::vector<char>& turned,
  const std::vector<double>& volumes);
} // namespace insideout
