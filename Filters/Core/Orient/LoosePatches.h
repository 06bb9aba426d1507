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
 * A patch is loose where the signed sum of facets at the seams it is at is 0 without the loose
 * ones, but not with them: as a wall across a box, at whose edges the box's own facets fit
 * together. Such a wall, and what it cuts off, are each loose if the other is not: taken is the one
 * that encloses less, its holes capped. Patches without seams are never loose.
 *
 * Patches are taken away one by one, those first that enclose least, as long as that shortens the
 * seams' imbalance, the length of seams times their signed sums; then those are put back at whose
 * seams others do not balance.
 *
 * @param[in] turned one per patch: 1 where its facets are to be turned over
 * @param[in] volumes one per patch: what it encloses then, holes capped
 * @return one per patch
 */
std::vector<char> FindLoosePatches(const SeamedPatches& patches, const std::vector<char>& turned,
  const std::vector<double>& volumes);
} // namespace insideout
