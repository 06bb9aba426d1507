// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Exact/DissolvePoint.h"
#include "Exact/EdgeRemoval.h"
#include "Exact/MovePoint.h"

#include <random>

namespace insideout
{
/** Takes Steiner points away again, or off the surface. */
class SteinerPoints
{
public:
  SteinerPoints(FlippableMesh& mesh, SegmentTable& segments, Monitor& monitor)
    : Mesh(mesh)
    , Segments(segments)
    , Progress(monitor)
    , Flips(mesh, segments)
    , Dissolver(mesh, segments)
    , Mover(mesh, segments)
  {
  }

  /**
   * Flip at random around points, and then try again to do without them, or to have them in the
   * volume: the cells that bar the way are others each time.
   */
  void Shake(const std::vector<Id>& points, std::mt19937& random);

  /** Flip at random in the cells around a vertex. */
  void FlipAround(Id vertex, std::mt19937& random);

  /**
   * Among the Steiner points from `first` on, replace those on facets by points beside them, where
   * the mesh cannot do without, and then remove what it can do without: in the volume that is more.
   * @param[in] since points around which nothing has changed since (FlippableMesh::NumberOfChanges)
   *            stay as they are
   */
  void Tidy(Id first, std::int64_t since = -1);

private:
  void MoveIntoVolume(Id first, std::int64_t since);
  void Remove(Id first, std::int64_t since);
  bool RemoveOne(Id point);
  bool Collapse(Id point);
  void LowerDegree(Id point);

  FlippableMesh& Mesh;
  SegmentTable& Segments;
  Monitor& Progress;
  FlipOperator Flips;
  PointDissolver Dissolver;
  PointMover Mover;
};
} // namespace insideout
