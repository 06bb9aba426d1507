// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/FlipTarget.h"
#include "Exact/SegmentTable.h"
#include "Mesh/RingTriangulation.h"

namespace insideout
{
/**
 * The flips: take a face or an edge out of a mesh, and choose of all ways to do so one that leaves
 * least in the way of a target. Constraints that are there stay.
 *
 * An edge with n cells around it goes by triangulating the ring of n points, of which every
 * triangle becomes two cells (Freitag and Ollivier-Gooch 1997); the best triangulation is found by
 * dynamic programming (Klincsek 1980).
 */
class FlipOperator
{
public:
  FlipOperator(FlippableMesh& mesh, const SegmentTable& segments)
    : Mesh(mesh)
    , Segments(segments)
  {
  }

  /** What a flip may cost: it is done if it leaves at most this much more in the way than before.
   */
  struct Limits
  {
    int Increase = -1;
    int LargestRing = 12;
  };

  /** Take the face across from corner `face` away: two cells become three. */
  bool RemoveFace(Id cell, int face, const FlipTarget& target, const Limits& limits);

  /** Take the edge between u and v, of `cell`, away. */
  bool RemoveEdge(Id u, Id v, Id cell, const FlipTarget& target, const Limits& limits);

  /**
   * The same; if that fails, first make the ring smaller by removing edges between it and u or v,
   * down to `depth` levels.
   * @param[in,out] budget how many more edges may be tried
   */
  bool RemoveEdgeDeeply(
    Id u, Id v, const FlipTarget& target, const Limits& limits, int depth, int& budget);

private:
  bool IsLocked(const EdgeRing& ring) const;
  bool IsHullFlip(const EdgeRing& ring) const;

  FlippableMesh& Mesh;
  const SegmentTable& Segments;

  // For the edge at hand; members so that their memory is kept.
  EdgeRing Around;
  RingTriangulation<int> Triangulation;
};
} // namespace insideout
