// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/FlippableMesh.h"

#include <vector>

namespace insideout
{
/**
 * The target of flips, a segment or a facet: it counts the obstacles among edges and faces.
 * Vertices may not move while it is in use.
 */
class FlipTarget
{
public:
  /** Without a target there are no obstacles. */
  explicit FlipTarget(const FlippableMesh& mesh)
    : Mesh(mesh)
  {
  }

  static FlipTarget Segment(const FlippableMesh& mesh, Id a, Id b);
  static FlipTarget Facet(const FlippableMesh& mesh, const Triangle& corners);

  /** 1 for a face whose inside or whose edges the segment crosses, else 0. */
  int CostOfFace(Id x, Id y, Id z) const;

  /** CostOfEdgeCrossing for an edge that the segment or the facet crosses, else 0. */
  int CostOfEdge(Id x, Id y) const;

private:
  bool SegmentCrosses(Id x, Id y) const;
  bool FacetCrosses(Id x, Id y) const;
  int SideOfFacet(Id x) const;

  const FlippableMesh& Mesh;
  enum
  {
    Nothing,
    ASegment,
    AFacet
  } Kind = Nothing;
  Triangle Corners{ { None, None, None } };

  /** The side of the facet's plane that a vertex is on. */
  struct Side
  {
    Id Vertex;
    int Sign;
  };
  mutable std::vector<Side> Sides; ///< cache: most edges asked for share vertices with others
};
} // namespace insideout
