// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/EdgeSet.h"
#include "Exact/FlippableMesh.h"
#include "Exact/SegmentTable.h"
#include "Mesh/IdSet.h"

#include <vector>

namespace insideout
{
/**
 * Cells that give way to a cone: new cells that join an apex with the boundary of their union, the
 * *wall*. Vertices, segments and facets on the wall stay.
 */
struct Cone
{
  IdSet Old; ///< the cells that give way
  std::vector<Tetrahedron> Fresh;
  std::vector<FreshFacet> Facets; ///< facets at the center, or None, of faces that stay

  /**
   * Make the new cells, and check whether every vertex, facet and segment stays. The center is the
   * one vertex that need not be on the wall; its facets stay if they can.
   * @param[in] gone a vertex whose faces are not walls, nor are those on the hull; None for none
   */
  bool Make(
    const FlippableMesh& mesh, const SegmentTable& segments, Id apex, Id centre, Id gone = None);

  /**
   * Whether the center is a corner of a facet, or of a face of the hull, between the replaced
   * cells.
   */
  bool HasSurface() const { return !this->Facets.empty(); }

private:
  bool Keeps(const Tetrahedron& cell, Id centre, const SegmentTable& segments) const;

  IdSet OnWall; ///< vertices
  EdgeSet WallEdges;
};
} // namespace insideout
