// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/ExactState.h"

namespace insideout
{
/**
 * Candidate positions in doubles for a Steiner point, nearest to its segment or facet first:
 * exactly on the segment, its nearest doubles, beside the segment, around it, and all along it.
 * Cells may be inverted there.
 */
std::vector<Point> PlacesFor(const ExactState& state, Id point);
} // namespace insideout
