// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "DissolvePoint.h"
#include "EdgeRemoval.h"
#include "Monitor.h"

namespace insideout
{
/** Takes Steiner points away again, and gives those that stay coordinates in doubles. */
class SteinerPoints
{
public:
  SteinerPoints(FlippableMesh& mesh, SegmentTable& segments, Monitor& monitor)
    : Mesh(mesh)
    , Segments(segments)
    , Progress(monitor)
    , Flips(mesh, segments)
    , Dissolver(mesh, segments)
  {
  }

  /** Take Steiner points away that the mesh can do without. */
  void Remove();

  /** Replace Steiner points on facets by points beside them. */
  void MoveIntoVolume();

  /**
   * Move the points that have no double coordinates to places that do, every cell around staying
   * positive, as near as this is possible.
   * @return the points for which it is not
   */
  std::vector<Id> Round();

  /** The facets that have the point within them or on their edges, ascending. */
  std::vector<Id> FacetsAt(Id point) const;

  bool IsInMesh(Id point) const;

private:
  /** What a point lies on. */
  struct Support
  {
    Id Segment;             ///< None for none
    std::vector<Id> Facets; ///< whose faces have the point
  };

  Support SupportOf(Id point) const;
  bool RemoveOne(Id point);
  void LowerDegree(Id point);

  bool IsValidAt(Id point, const std::vector<Id>& star, const Point& place);
  bool RoundOne(Id point);
  bool RoundOnSegment(Id point, Id segment, const std::vector<Id>& star, bool exactly);

  FlippableMesh& Mesh;
  SegmentTable& Segments;
  Monitor& Progress;
  FlipOperator Flips;
  PointDissolver Dissolver;
};
} // namespace insideout
