// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/FlippableMesh.h"

namespace insideout
{
/**
 * What flips shall clear the way for, a segment or a facet: it counts how much an edge or a face is
 * in its way.
 */
class FlipTarget
{
public:
  /** Nothing is in the way of no target. */
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

  const FlippableMesh& Mesh;
  enum
  {
    Nothing,
    ASegment,
    AFacet
  } Kind = Nothing;
  Triangle Corners{ { None, None, None } };
};
} // namespace insideout
