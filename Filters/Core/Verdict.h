// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Statistics.h"

#include <string>

namespace insideout
{
/**
 * State whether a surface bounds a solid, and its volume, in one sentence without a period. The
 * statistics are those of FindSurfaceDefects, or of a solid, whose volume is then given; statistics
 * of planar curves give the same about areas.
 *
 * A volume is either exact to the printed digits, or `about` a value, with 95 % bounds, and with no
 * finer digits than these.
 */
std::string Verdict(const Statistics& statistics);

/** A volume in words. @param[in] low, high bounds of the volume, equal if it is exact */
std::string VolumeInWords(double volume, double low, double high);
} // namespace insideout
