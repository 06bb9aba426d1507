// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/CavityWall.h"
#include "Exact/FlippableMesh.h"
#include "Exact/SegmentTable.h"

namespace insideout
{
/**
 * Moves a vertex to another place and reconnects it as if it were removed and inserted (Bowyer
 * 1981, Watson 1981, with visibility in the place of empty spheres): the cells around it give way,
 * then each cell behind a face that does not see the new place. New cells join the vertex with the
 * boundary of their union. All other vertices, facets and segments stay.
 */
class PointMover
{
public:
  PointMover(FlippableMesh& mesh, const SegmentTable& segments)
    : Mesh(mesh)
    , Segments(segments)
  {
  }

  /** @return whether it is there; else the mesh is as before */
  bool Move(Id point, const Point& place);

  /**
   * Put a vertex that lies on no facet, segment or face of the hull out of the mesh; what was
   * connected with it, and what is in the way, is connected with a neighbor of it.
   * @return whether it is gone; else the mesh is as before
   */
  bool Collapse(Id point, Id neighbor);

private:
  bool GrowCavity(Id point, Id apex);
  bool KeepsSurface(Id point, Id apex);
  bool IsHullConvex(Id point, Id apex) const;

  FlippableMesh& Mesh;
  const SegmentTable& Segments;

  // For the move at hand; members so that their memory is kept.
  std::vector<Id> Cavity;
  std::vector<Tetrahedron> Fresh;
  CavityWall Wall;
  std::vector<SurfaceFace> SurfaceFaces; ///< with the point
};
} // namespace insideout
