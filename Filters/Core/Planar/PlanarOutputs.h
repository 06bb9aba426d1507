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
  Id Segment;              ///< segment of the curve on the edge, None for none
  bool IsAlong;            ///< the edge runs as that segment does
};

/**
 * The boundary of the inside triangles: their edges with no inside triangle beyond. At every point
 * equally many begin and end.
 *
 * @param[in] inside one value per cell, 0 for outside
 * @return in the order of their cells, then of the edges in the cell
 */
std::vector<BoundaryEdge> BoundaryEdges(
  const PlanarMesh& mesh, const std::vector<unsigned char>& inside);

/** A segment that is not an edge of an inside triangle. */
struct OutlierSegment
{
  Id Segment; ///< of the curve
  OutlierReason Reason;
};

/**
 * Segments without an inside triangle on either side, and segments that could not be resolved;
 * ascending.
 */
std::vector<OutlierSegment> OutlierSegments(
  const SegmentComplex& curve, const PlanarMesh& mesh, const std::vector<unsigned char>& inside);

/**
 * Join segments to polylines. A polyline continues through each point where exactly one segment
 * ends, one begins, and both have the same key. A closed one repeats its first point at its end.
 *
 * @param[in] keys one per segment
 * @return per polyline its segments' indices in sequence; ordered by the first
 */
std::vector<std::vector<Id>> JoinAlong(
  const std::vector<Segment>& segments, const std::vector<Id>& keys);

/**
 * Copy points in which inside triangles touch without being connected through edges around it
 * (PartCells): two edges of the boundary then end at each of its points.
 *
 * @param[in,out] curve gains the copies as its last points
 * @return their number
 * @throws Error Stopped
 */
Id SplitPoints(SegmentComplex& curve, PlanarMesh& mesh, const std::vector<unsigned char>& inside,
  Monitor& monitor, const ProgressRange& progress);

/** Components of the solid, connected through edges. */
SolidRegions FindRegions(const PlanarMesh& mesh, const std::vector<unsigned char>& inside,
  Monitor& monitor, const ProgressRange& progress);

/** Mass properties of a region of the plane, in the units of its points. All 0 without a region. */
struct AreaProperties
{
  double Area = 0;
  Point Center = { { 0, 0, 0 } };
};

/** Area and center of each region. */
std::vector<AreaProperties> MeasureRegions(const SegmentComplex& curve, const PlanarMesh& mesh,
  const Plane& plane, const SolidRegions& regions);
} // namespace insideout
