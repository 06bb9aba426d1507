// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/Statistics.h"
#include "Planar/FindPlane.h"
#include "Planar/PlanarCurve.h"
#include "Validate/CountedChain.h"

#include <string>

namespace insideout
{
/** What counting found. */
struct CurveCounts
{
  Id InputPoints = 0;
  Id InputSegments = 0;
  Id Points = 0;             ///< that segments use, after merging
  Id Segments = 0;           ///< that have a length, each counted once
  Id MergedPoints = 0;       ///< input points that became one with a point of lower id
  Id DegenerateSegments = 0; ///< left out: two equal points
  Id DuplicateSegments = 0;  ///< input segments whose two points an earlier one has
  Id CancelledSegments = 0;  ///< given both ways, so that they cancel
  Id TwoSidedCurves = 0;     ///< of these: closed curves that are kept once (KeepTwoSidedCurves)
  Id OpenEnds = 0;           ///< points at which the signed count of segments is not 0
  Id Components = 0;         ///< of segments joined through points
};

struct CountedCurve
{
  SegmentComplex Curve; ///< only points that a segment uses, in the input's order
  CurveCounts Counts;
  std::vector<Id> MergedInto;         ///< per point of the soup the one that it became, or itself
  std::vector<Id> DegenerateSegments; ///< of the soup: left out; ascending
};

/**
 * Stage validate in a plane, by the rules of CountFacets: points with equal coordinates become one;
 * segments without length are left out; those with the same two points become one, whose
 * multiplicity counts them once per direction, opposite ones cancelling; it stays a constraint at
 * 0, unless a closed curve is given both ways as a whole (KeepTwoSidedCurves). Where the soup comes
 * with multiplicities, or duplicates are to be counted, these add instead.
 *
 * @param[in] plane through the soup's points
 * @throws Error EmptySurface, PointNotFinite, PointOutOfRange, AllDegenerate, InvalidParameter,
 *         TooLarge, Stopped; segments and points are named by their index in `soup`
 */
CountedCurve CountSegments(const SegmentSoup& soup, const Plane& plane,
  const CountedChainParameters& parameters, Monitor& monitor);

/** @throws Error what CountSegments throws of segments and points that are no good */
void CheckSegments(const SegmentSoup& soup);

/** The number of points at which unequally many segments begin and end, all counted: the curve's
 * open ends. */
Id NumberOfOpenEnds(const SegmentComplex& curve);

/** The counts under their names, for `statistics`. */
void AddCounts(const CurveCounts& counts, Statistics& statistics);
} // namespace insideout
