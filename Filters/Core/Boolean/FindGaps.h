// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Boolean/ResolveBodies.h"

namespace insideout
{
/**
 * Whether there may be gaps between bodies that FillGaps closes: whether any facet of other bodies
 * has all corners within the tolerance of a body. It may also lie inside the body.
 *
 * @param[in] tolerance above 0
 * @throws Error (Stopped)
 */
bool MayHaveGaps(const ResolvedBodies& bodies, double tolerance, Monitor& monitor);
} // namespace insideout
