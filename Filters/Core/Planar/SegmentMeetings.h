// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/ProgressRange.h"
#include "Planar/PlanarCurve.h"

#include <vector>

namespace insideout
{
/** A point that lies within a segment. */
struct SegmentTouch
{
  Id Segment;
  Id Point;
};

/** Intersections of segments beyond shared points, exactly. */
struct SegmentMeetings
{
  std::vector<SegmentTouch> Touches; ///< possibly with repetitions
  /// pairs of segments that cross in the interior of both, lower first
  std::vector<Segment> Crossings;
  std::size_t Pairs = 0; ///< of segments that meet
  bool Empty() const { return this->Touches.empty() && this->Crossings.empty(); }
};

/**
 * Find where segments meet other than in shared points. A tree of boxes comes first, then exact
 * predicates, on all threads; the result does not depend on their number.
 *
 * @param[in] points no two equal
 * @param[in] segments each of two different points
 * @param[in] isNew one per segment: pairs without a new one are known not to meet. Empty: all are
 * new
 */
SegmentMeetings FindSegmentMeetings(const std::vector<PlanarPoint>& points,
  const std::vector<Segment>& segments, const std::vector<char>& isNew, Monitor& monitor,
  const ProgressRange& progress);
} // namespace insideout
