// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Planar/PlanarHull.h"

namespace insideout
{
/** The defects at a point of a curve. */
enum class CurveDefect : unsigned char
{
  OpenEnd,  ///< unequal numbers of segments begin and end there
  Crossing, ///< segments cross in the interior of both
  TJunction ///< a point lies within a segment, or an overlap of segments begins there
};

/** The position of a defect. */
struct CurveDefectPoint
{
  PlanarPoint Place;
  Id InputPoint; ///< None for a new one
  CurveDefect Type;
};

/** The defects of an input segment. */
struct SegmentDefects
{
  /// component of segments joined through points, by first segment; None: degenerate
  Id Component = None;
  Id SelfIntersections = 0; ///< number of segments that it meets beyond shared ends
  bool Degenerate = false;
  bool Duplicate = false; ///< an earlier segment has the same two points
};

struct CurveDefects
{
  std::vector<SegmentDefects> Segments; ///< one per segment of the soup
  std::vector<CurveDefectPoint> Points; ///< number by type
  CurveCounts Counts;
  std::size_t IntersectingPairs = 0;
  std::vector<Id> TurnedSegments; ///< ids of segments turned over by the orientation, ascending
  AreaReadings Areas;             ///< area then enclosed
  std::vector<std::string> Warnings;
};

/**
 * Find the defects of a curve in a plane, without changing it.
 *
 * @throws Error as MeshPlanarHull
 */
CurveDefects FindCurveDefects(const SegmentSoup& soup, const Plane& plane,
  const PlanarHullParameters& parameters, Monitor& monitor);
} // namespace insideout
