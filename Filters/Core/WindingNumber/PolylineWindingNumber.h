// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/PlanarPoint.h"
#include "Common/Types.h"
#include "WindingNumber/ArgumentSum.h"

#include <cstdint>
#include <vector>

namespace insideout
{
/** A line from one point to another, and its count in that direction. */
struct CountedSegment
{
  Id From;
  Id To;
  int Count;
};

/**
 * The winding number of polylines in the plane, closed or open, at any point (thesis, chapter 8):
 * positive where they run counter-clockwise around it.
 *
 * A segment's angle is the difference of its ends' arguments, plus a whole turn if it crosses the
 * ray to the left of the point. Summed over the segments, the differences leave one argument per
 * loose end. So a closed polyline's winding number is a count of crossings, decided by exact
 * predicates and found in a tree whose nodes know their own loose ends. The arguments of many loose
 * ends are summed in a tree, too (ArgumentSum.h).
 *
 * On a segment w is the mean of both sides, in a closed polygon's corner the angle over 2 pi.
 */
class PolylineWindingNumber
{
public:
  /**
   * @param[in] points finite, also their differences
   * @param[in] metric in which angles are measured
   */
  PolylineWindingNumber(std::vector<PlanarPoint> points,
    const std::vector<CountedSegment>& segments, const PlanarMetric& metric = PlanarMetric());

  /** At one finite point. Safe to call from several threads. */
  double At(const PlanarPoint& p) const;

  /**
   * At the exact mean of three finite points that run counter-clockwise. The side of each segment
   * is exact; angles are exact up to rounding, also near open ends.
   */
  double AtMean(const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c) const;

  /**
   * One value per point, on as many threads as pay off.
   * @throws Error (Stopped)
   */
  std::vector<double> At(const std::vector<PlanarPoint>& points, Monitor& monitor) const;

  /** Whether w is a whole number away from the polylines. */
  bool IsClosed() const { return this->LooseEnds.empty(); }

private:
  /** A point, and the number of segments that end there minus those that begin. */
  struct LooseEnd
  {
    Id Point;
    std::int64_t Count;
  };
  struct Node
  {
    PlanarPoint Low;
    PlanarPoint High;
    std::size_t Begin; ///< of its segments
    std::size_t End;
    std::size_t Right; ///< its second child, 0 for a leaf; the first one is the next node
    CountsAbove LooseEnds;
  };

  void Build(std::size_t begin, std::size_t end);
  std::vector<LooseEnd> LooseEndsOf(std::size_t begin, std::size_t end) const;
  template <typename Place>
  double Argument(Id point, const Place& place) const;
  template <typename Place>
  double Crossing(const CountedSegment& segment, const Place& place) const;
  template <typename Place>
  double AtPlace(const Place& place) const;

  std::vector<PlanarPoint> Points;
  PlanarMetric Metric;
  std::vector<CountedSegment> Segments;
  std::vector<LooseEnd> LooseEnds;
  ArgumentSum Arguments; ///< of the loose ends
  std::vector<Node> Nodes;
};
} // namespace insideout
