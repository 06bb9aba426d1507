// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Boolean/BodyRegions.h"

#include <string>
#include <vector>

namespace insideout
{
/**
 * Tell a user what bodies lose to others, and the options that change it: bodies or parts of bodies
 * without a cell; bodies that keep less than half of their volume because others come before them;
 * bodies that come before those within them in vain. No body loses anything with RegionRule All.
 *
 * @param[in] inside, order, regions as FindBodyRegions took and gave them
 * @param[in] names of all bodies
 * @throws Error Stopped
 */
std::vector<std::string> WarningsOfCoveredBodies(const TetrahedralMesh& mesh,
  const std::vector<std::vector<unsigned char>>& inside, const BodyOrder& order,
  const BodyRegions& regions, const std::vector<std::string>& names, Monitor& monitor,
  const ProgressRange& progress);
} // namespace insideout
