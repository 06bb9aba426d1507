// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/MeshReader.h"

namespace insideout
{
/** Where a segment between two vertices passes through the mesh. */
struct Crossing
{
  enum KindOfCrossing
  {
    ThroughFace, ///< out of Cell through its face across from corner Face
    ThroughEdge, ///< over the edge from U to V of Cell
    AtEnd,       ///< Cell has the end: nothing more is crossed
    AtVertex     ///< the segment passes through vertex U, where U is not None, or along an edge
  } Kind;
  Id Cell;
  int Face;
  Id U;
  Id V;
};

/** The first face, edge or vertex that the segment from a to b crosses. */
Crossing FirstCrossing(const MeshReader& mesh, Id a, Id b);

/** The next one that it crosses after a face or an edge. */
Crossing NextCrossing(const MeshReader& mesh, Id a, Id b, const Crossing& crossing);
} // namespace insideout
