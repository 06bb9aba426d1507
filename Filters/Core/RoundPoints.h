// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Monitor.h"
#include "MovePoint.h"

namespace insideout
{
/**
 * Gives Steiner points that lie exactly on segments and facets coordinates in doubles. A point on a
 * segment may go anywhere along it; off the exact place every point may go as far as rounding
 * errors are large, and the facets around bend with it. All cells stay positive, so nothing comes
 * to cross. Where the new place would turn cells over, others take their place (PointMover).
 */
class PointRounder
{
public:
  PointRounder(FlippableMesh& mesh, const SegmentTable& segments, Monitor& monitor)
    : Mesh(mesh)
    , Segments(segments)
    , Progress(monitor)
    , Mover(mesh, segments)
  {
  }

  /** Round all points that can be. @return the ones that are left */
  std::vector<Id> Round();

private:
  bool RoundOne(Id point);

  std::vector<Point> PlacesOnSegment(Id point, Id segment, bool exactly) const;
  std::vector<Point> PlacesBetweenNeighbors(Id point, Id segment) const;
  std::vector<Point> PlacesBeside(Id point, const double* steps, std::size_t numberOfSteps) const;

  FlippableMesh& Mesh;
  const SegmentTable& Segments;
  Monitor& Progress;
  PointMover Mover;
};
} // namespace insideout
