// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Boolean/BodyRegions.h"

#include <string>
#include <vector>

namespace insideout
{
/**
 * Messages about volume that bodies lose to others, with the options that change it: bodies or
 * parts without a cell; bodies that keep less than half of their volume because of others of higher
 * priority; bodies whose priority over bodies within them has no effect. No body loses anything
 * with RegionRule All.
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
