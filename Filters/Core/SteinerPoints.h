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

  /** Take Steiner points away that the mesh can do without. */
  void Remove();

  /** Replace Steiner points on facets by points beside them. */
  void MoveIntoVolume();

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
