// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/ExactState.h"

namespace insideout
{
/**
 * Candidate positions in doubles for a Steiner point, those nearest to its segment or facet first:
 * exactly on its segment, its nearest doubles, beside the segment, around, and all along the
 * segment. The cells around need not stay positive there.
 */
std::vector<Point> PlacesFor(const ExactState& state, Id point);
} // namespace insideout
