// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Statistics.h"

#include <string>

namespace insideout
{
/**
 * Say whether a surface bounds a solid, and of what volume, in one sentence without a period. The
 * statistics are those of FindSurfaceDefects, or of a solid that was made, whose volume is told
 * then; statistics of curves in a plane give the same about areas.
 *
 * A volume is exact to the digits printed; or it is `about` one, with bounds that hold it in 95 of
 * 100 cases, and digits no finer than these.
 */
std::string Verdict(const Statistics& statistics);

/** A volume in words. @param[in] low, high bounds of the volume, equal if it is exact */
std::string VolumeInWords(double volume, double low, double high);
} // namespace insideout
