// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Statistics.h"
#include "Output/Outliers.h"
#include "Output/Regions.h"
#include "Planar/FindPlane.h"
#include "Planar/PlanarCurve.h"

namespace insideout
{
/** An edge between an inside triangle and the outside. */
struct BoundaryEdge
{
  insideout::Segment Ends; ///< the solid is on its left
  Id Segment;              ///< of the curve that the edge is, None for none
  bool IsAlong;            ///< runs as that segment does
};

/**
 * The boundary of the inside triangles: their edges with no inside triangle beyond. At every point
 * as many begin as end.
 *
 * @param[in] inside one value per cell, 0 for outside
 * @return in the order of their cells, then of the edges in the cell
 */
std::vector<BoundaryEdge> BoundaryEdges(
  const PlanarMesh& mesh, const std::vector<unsigned char>& inside);

/** A segment that is no edge of an inside triangle. */
struct OutlierSegment
{
  Id Segment; ///< of the curve
  OutlierReason Reason;
};

/** Segments without an inside triangle on either side, and those that were left out; ascending. */
std::vector<OutlierSegment> OutlierSegments(
  const SegmentComplex& curve, const PlanarMesh& mesh, const std::vector<unsigned char>& inside);

/**
 * Polylines out of segments: each segment is a part of one, and a polyline goes on through every
 * point where one segment ends, one begins, and both have the same key. A closed one repeats its
 * first point at its end.
 *
 * @param[in] keys one per segment
 * @return per polyline its segments, by indices, one behind the other; ordered by the first
 */
std::vector<std::vector<Id>> JoinAlong(
  const std::vector<Segment>& segments, const std::vector<Id>& keys);

/**
 * Copy points in which triangles inside touch, and no edges lead from one to the other around them
 * (PartCells): at every point of the boundary two of its edges end then.
 *
 * @param[in,out] curve gains the copies as its last points
 * @return how many there are
 * @throws Error Stopped
 */
Id SplitPoints(SegmentComplex& curve, PlanarMesh& mesh, const std::vector<unsigned char>& inside,
  Monitor& monitor, const ProgressRange& progress);

/** Parts of the solid that edges connect. */
SolidRegions FindRegions(const PlanarMesh& mesh, const std::vector<unsigned char>& inside,
  Monitor& monitor, const ProgressRange& progress);

/** Mass properties of a part of the plane, in the units of its points. All 0 where there is no
 * part. */
struct AreaProperties
{
  double Area = 0;
  Point Center = { { 0, 0, 0 } };
};

/** Area and center of each region. */
std::vector<AreaProperties> MeasureRegions(const SegmentComplex& curve, const PlanarMesh& mesh,
  const Plane& plane, const SolidRegions& regions);
} // namespace insideout
