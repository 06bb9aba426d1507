// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/CavityWall.h"
#include "Exact/FlippableMesh.h"
#include "Exact/SegmentTable.h"

namespace insideout
{
/**
 * Connects a vertex with several others at once. The cells that the segments to them cross give way
 * to a cone from the vertex over the boundary of their union. Cells behind faces that do not see
 * the vertex belong to that union. Vertices, facets, segments and the hull stay; coplanar faces of
 * the hull may be triangulated another way.
 *
 * Points of CAD models are (nearly) cospherical: more than one mesh is (nearly) Delaunay. This
 * chooses the one that facets need: the pulling triangulation (Lee 1991).
 */
class VertexPuller
{
public:
  VertexPuller(FlippableMesh& mesh, const SegmentTable& segments)
    : Mesh(mesh)
    , Segments(segments)
  {
  }

  /**
   * Others behind a facet or segment are passed over. The mesh stays as it is where the cone would
   * break a constraint, or add more than one cell per two segments: flips add one for each.
   * @return whether the vertex is connected with all others that were not passed over
   */
  bool Pull(Id apex, const std::vector<Id>& others);

private:
  bool AddCrossed(Id apex, Id other);
  void Add(Id cell);
  bool Sees(const Tetrahedron& cell) const;
  bool IsOnHullFace(Id cell, Id apex) const;
  bool Grow(Id apex);
  void MakeCone(Id apex);
  bool KeepsConstraints(Id apex);
  bool KeepsFacets(Id apex, Id cell);

  FlippableMesh& Mesh;
  const SegmentTable& Segments;

  // For the vertex at hand; members so that their memory is kept.
  std::vector<Id> Cavity;
  CellMarks Inside;
  std::vector<Id> Crossed;
  EdgeRing Ring;
  std::vector<Tetrahedron> Fresh;
  CavityWall Wall;
  std::vector<SurfaceFace> SurfaceFaces; ///< inner faces with the apex
};
} // namespace insideout
