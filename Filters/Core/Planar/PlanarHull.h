// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Orient/OrientFacets.h"
#include "Planar/CountSegments.h"
#include "Planar/FindPlane.h"
#include "Planar/PlanarCurve.h"

namespace insideout
{
struct PlanarHullParameters
{
  CountedChainParameters Chain;
  insideout::Orientation Orientation = insideout::Orientation::Automatic;
};

/** The area that a curve encloses by each of three rules, in the units of the input. */
struct AreaReadings
{
  double EvenOdd = 0; ///< region with odd winding number
  double Winding = 0; ///< region with w > 1/2
  double AsGiven = 0; ///< region with w > 1/2 if no segment is turned over; only if Differ()

  /** The rules differ, segments cross, and a part of the curve runs clockwise around space that no
   * other part encloses. */
  bool Across = false;
  /** The rules differ, and a part of the curve encloses another with the same direction, as
   * contours of DICOM do. */
  bool Within = false;

  /** The curve may mean a hole that the winding number fills. */
  bool Differ() const { return this->Across || this->Within; }
};

/** The convex hull of a curve in triangles, and the curve's winding number in each. */
struct PlanarHull
{
  insideout::Plane Plane;
  SegmentComplex Curve; ///< resolved; segments oriented as requested
  PlanarMesh Mesh;
  std::vector<double> W; ///< one per cell
  CurveCounts Counts;
  std::vector<Id> MergedInto;         ///< as CountedCurve's
  std::vector<Id> DegenerateSegments; ///< as CountedCurve's
  std::vector<Id> TurnedSegments;     ///< segments of the soup that were turned over; ascending
  AreaReadings Areas;
  insideout::Statistics Statistics;
  std::vector<std::string> Warnings;
};

/**
 * Stages validate to w in a row, in a plane: count the segments, cut them where they meet,
 * triangulate the convex hull, orient segments, and find the winding numbers.
 *
 * @throws Error of any stage
 */
PlanarHull MeshPlanarHull(const SegmentSoup& soup, const Plane& plane,
  const PlanarHullParameters& parameters, Monitor& monitor);

/** Append the three areas by name to `statistics`, if they differ. */
void AddAreas(const AreaReadings& areas, Statistics& statistics);
} // namespace insideout
