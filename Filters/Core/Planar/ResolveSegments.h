// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Planar/PlanarCurve.h"

namespace insideout
{
struct ResolvedCurve
{
  SegmentComplex Curve;
  std::size_t IntersectingPairs = 0; ///< given segments that were left out
  int Rounds = 0;                    ///< rounds of cutting and rounding
};

/**
 * Stage pre in a plane: cut segments where they cross, touch or overlap, decided by exact
 * predicates. Crossings are rounded to doubles; segments that then cross are cut again, until none
 * do. Input points never move. If a crossing is nearer to an end of a segment than rounding can
 * resolve, both segments pass through that end. This tolerance grows from round to round, to less
 * than 1e-12 of the size, so that the process ends; segments that still cross in the last round are
 * left out (NumberOfConstraints).
 *
 * The pieces of a segment are in sequence along it. Coincident pieces of several segments are
 * merged, and their multiplicities add. The given points come first, in their order, then the new
 * ones.
 *
 * @param[in] curve from CountSegments
 * @throws Error TooLarge, Stopped
 */
ResolvedCurve ResolveSegments(const SegmentComplex& curve, Monitor& monitor);
} // namespace insideout
