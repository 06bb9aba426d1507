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
/** The result of counting. */
struct CurveCounts
{
  Id InputPoints = 0;
  Id InputSegments = 0;
  Id Points = 0;             ///< points used by segments, after merging
  Id Segments = 0;           ///< segments with a length, each counted once
  Id MergedPoints = 0;       ///< input points merged with a point of lower id
  Id DegenerateSegments = 0; ///< left out: two equal points
  Id DuplicateSegments = 0;  ///< input segments with the same points as an earlier one
  Id CancelledSegments = 0;  ///< given in both directions, so that they cancel
  Id TwoSidedCurves = 0;     ///< closed curves among these that are kept once (KeepTwoSidedCurves)
  Id OpenEnds = 0;           ///< points at which the signed count of segments is not 0
  Id Components = 0;         ///< of segments joined through points
};

struct CountedCurve
{
  SegmentComplex Curve; ///< only points that a segment uses, in the input's order
  CurveCounts Counts;
  /// per point of the soup the point that it was merged with, or itself
  std::vector<Id> MergedInto;
  std::vector<Id> DegenerateSegments; ///< of the soup: left out; ascending
};

/**
 * Stage validate in a plane, by the rules of CountFacets. Points with equal coordinates are merged;
 * segments without length are left out. Segments with the same two points become one, whose
 * multiplicity counts them once per direction; opposite ones cancel. With multiplicity 0 it stays a
 * constraint, unless a closed curve as a whole is given in both directions (KeepTwoSidedCurves). If
 * the soup has multiplicities, or duplicates are to be counted, these add instead.
 *
 * @param[in] plane through the soup's points
 * @throws Error EmptySurface, PointNotFinite, PointOutOfRange, AllDegenerate, InvalidParameter,
 *         TooLarge, Stopped; segments and points are named by their index in `soup`
 */
CountedCurve CountSegments(const SegmentSoup& soup, const Plane& plane,
  const CountedChainParameters& parameters, Monitor& monitor);

/** @throws Error as CountSegments does for invalid segments and points */
void CheckSegments(const SegmentSoup& soup);

/** The number of points at which the numbers of beginning and ending segments, all counted, differ:
 * the curve's open ends. */
Id NumberOfOpenEnds(const SegmentComplex& curve);

/** The counts by name, for `statistics`. */
void AddCounts(const CurveCounts& counts, Statistics& statistics);
} // namespace insideout
