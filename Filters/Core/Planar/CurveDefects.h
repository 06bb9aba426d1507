// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Planar/PlanarHull.h"

namespace insideout
{
/** The defects at a point of a curve. */
enum class CurveDefect : unsigned char
{
  OpenEnd,  ///< more segments begin than end there, or the other way round
  Crossing, ///< segments cross within both
  TJunction ///< a point lies within a segment, or segments overlap from there on
};

/** A place where something is wrong. */
struct CurveDefectPoint
{
  PlanarPoint Place;
  Id InputPoint; ///< None for a new one
  CurveDefect Type;
};

/** The defects of an input segment. */
struct SegmentDefects
{
  Id Component = None; ///< of segments joined through points, by first segment; None: degenerate
  Id SelfIntersections = 0; ///< segments that it meets beyond shared ends
  bool Degenerate = false;
  bool Duplicate = false; ///< an earlier segment has the same two points
};

struct CurveDefects
{
  std::vector<SegmentDefects> Segments; ///< one per segment of the soup
  std::vector<CurveDefectPoint> Points; ///< by type
  CurveCounts Counts;
  std::size_t IntersectingPairs = 0;
  std::vector<Id> TurnedSegments; ///< ids of segments that the orientation turns over, ascending
  AreaReadings Areas;             ///< enclosed then
  std::vector<std::string> Warnings;
};

/**
 * The defects of a curve in a plane, of which nothing is changed.
 *
 * @throws Error what MeshPlanarHull throws
 */
CurveDefects FindCurveDefects(const SegmentSoup& soup, const Plane& plane,
  const PlanarHullParameters& parameters, Monitor& monitor);
} // namespace insideout
