// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Statistics.h"

#include <string>

namespace insideout
{
/**
 * Whether a surface bounds a solid, and of what volume, in one sentence without a period: by the
 * statistics of FindSurfaceDefects, or of a solid that was made, whose volume is told then. Of
 * curves in a plane the same about areas.
 *
 * A volume is exact to the digits printed; or it is `about` one, with the bounds that it is between
 * in 95 of 100 cases, and digits no finer than these.
 */
std::string Verdict(const Statistics& statistics);

/** Such a volume in words. @param[in] low, high the same as the volume where it is exact */
std::string VolumeInWords(double volume, double low, double high);
} // namespace insideout
