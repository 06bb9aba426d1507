// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "DissolvePoint.h"
#include "EdgeRemoval.h"
#include "Monitor.h"
#include "MovePoint.h"

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

  /** Take Steiner points away that the mesh can do without, of those from `first` on. */
  void Remove(Id first, int mostPasses);

  /** Replace Steiner points on facets, of those from `first` on, by points beside them. */
  void MoveIntoVolume(Id first);

  /** Remove what can be; move what is left into the volume, from where more can be removed. */
  void Tidy(Id first);

private:
  bool RemoveOne(Id point);
  bool Collapse(Id point);
  std::vector<Id> NeighborsOf(Id point) const;
  void LowerDegree(Id point);

  FlippableMesh& Mesh;
  SegmentTable& Segments;
  Monitor& Progress;
  FlipOperator Flips;
  PointDissolver Dissolver;
  PointMover Mover;
};
} // namespace insideout
