// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Planar/PlanarCurve.h"

namespace insideout
{
struct TwoSidedCurves
{
  Id Closed = 0; ///< now kept once, counter-clockwise
  Id Sheets = 0; ///< left at multiplicity 0
};

/**
 * Find the components in which every participating segment was given equally often in both
 * directions. Their chains consist of segments joined through points of exactly two. If a chain
 * encloses an area when each segment is kept once, it gets multiplicities of +1 and -1 that make it
 * counter-clockwise, as KeepTwoSidedSolids does with facets. The others are sheets, and stay at 0.
 *
 * @param[in,out] curve counted and not yet resolved; Multiplicity changes
 */
TwoSidedCurves KeepTwoSidedCurves(const SegmentSoup& soup, SegmentComplex& curve);
} // namespace insideout
