// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Planar/PlanarCurve.h"

namespace insideout
{
struct ResolvedCurve
{
  SegmentComplex Curve;
  std::size_t IntersectingPairs = 0; ///< of the segments that were given
  int Rounds = 0;                    ///< of cutting and rounding
};

/**
 * Stage pre in a plane: segments cut where they cross, touch or overlap, which exact predicates
 * decide; crossings are rounded to doubles, and what that makes cross is cut again, until nothing
 * does. Points of the input never move. Where a crossing is nearer to an end of a segment than
 * rounding can tell, both pass through that end. That distance grows from round to round, to less
 * than 1e-12 of the size, so that this ends; segments that still cross in the last round are left
 * out (NumberOfConstraints).
 *
 * The pieces of a segment are one behind the other along it. Pieces of several segments that
 * coincide become one, whose multiplicities add. Points come in the order of the given ones, then
 * new ones.
 *
 * @param[in] curve as CountSegments gives it
 * @throws Error TooLarge, Stopped
 */
ResolvedCurve ResolveSegments(const SegmentComplex& curve, Monitor& monitor);
} // namespace insideout
