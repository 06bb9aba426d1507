// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/ExactState.h"

namespace insideout
{
/**
 * Places in doubles for a Steiner point, the ones first that leave it nearest to what it lies on:
 * on its segment exactly, its nearest doubles, beside the segment, around, and all along the
 * segment. The cells around need not stay positive there.
 */
std::vector<Point> PlacesFor(const ExactState& state, Id point);

/** Places all along the way between two vertices, each a little aside, too. */
std::vector<Point> PlacesBetween(const FlippableMesh& mesh, Id u, Id v);
} // namespace insideout
