// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Exact/MovePoint.h"
#include "Exact/SteinerPoints.h"

#include <random>

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
  PointRounder(FlippableMesh& mesh, SegmentTable& segments, Monitor& monitor)
    : Mesh(mesh)
    , Segments(segments)
    , Progress(monitor)
    , Mover(mesh, segments)
    , Steiner(mesh, segments, monitor)
  {
  }

  /**
   * Round all points that can be, and try to do without those that cannot, first in order and then
   * at random, as long as there get fewer.
   * @param[in] maySplitBeside whether further points may come in the end (SplitBeside)
   * @param[in] since as for SteinerPoints::Tidy
   * @return the ones that are left
   */
  std::vector<Id> RoundAll(bool maySplitBeside, std::int64_t since, std::mt19937& random);

  /** Round each point at the first of its places that will do. @return the ones that are left */
  std::vector<Id> Round();

  /** The same, of the places for each point only some at random. */
  std::vector<Id> RoundSomehow(std::mt19937& random);

  /** Move Steiner points around some points to other places at random: they may be in the way. */
  void Stir(const std::vector<Id>& points, std::mt19937& random);

  /**
   * Put further Steiner points, in doubles, on both sides of those that lie on segments. Where a
   * segment passes between facets that are less than rounding errors apart, no place in doubles may
   * be there for one point, but for two, one on either side.
   */
  void SplitBeside(const std::vector<Id>& points, std::mt19937& random);

private:
  bool SplitAt(Id segment, const EdgeRing& ring, const Point& place);
  Point RandomPlaceInVolume(Id point, std::mt19937& random) const;
  std::vector<Id> Unrounded() const;

  FlippableMesh& Mesh;
  SegmentTable& Segments;
  Monitor& Progress;
  PointMover Mover;
  SteinerPoints Steiner;
};
} // namespace insideout
