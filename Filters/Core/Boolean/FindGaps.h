// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Boolean/ResolveBodies.h"

namespace insideout
{
/**
 * Whether there may be gaps between bodies that FillGaps closes: whether a facet that is none of a
 * body has no corner that is farther from the body than the tolerance. It may also lie within the
 * body.
 *
 * @param[in] tolerance above 0
 * @throws Error (Stopped)
 */
bool MayHaveGaps(const ResolvedBodies& bodies, double tolerance, Monitor& monitor);
} // namespace insideout
