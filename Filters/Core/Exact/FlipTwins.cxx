// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/FlipTwins.h"

#include "Exact/EngineLimits.h"

namespace insideout
{
void FlipTwinsAway(ConstrainedMesh& constrained)
{
  FlippableMesh& mesh = constrained.Mesh;
  const SegmentTable& segments = constrained.Segments;
  FlipOperator flips(mesh, segments);
  const FlipTarget nothing(mesh);
  constexpr FlipEffort effort = EngineLimits::TwinFlips;
  for (Id facet = 0; facet < static_cast<Id>(constrained.Facets.size()); ++facet)
  {
    const Triangle& corners = constrained.Facets[facet];
    for (int k = 0; k < 3; ++k)
    {
      Id cell;
      int face;
      if (segments.IsSplit(segments.OfFacet(facet, k)) &&
        mesh.FindFace(corners[0], corners[1], corners[2], cell, face) &&
        !flips.RemoveFace(cell, face, nothing, effort.Limits))
      {
        int budget = effort.Budget;
        flips.RemoveEdgeDeeply(
          corners[k], corners[(k + 1) % 3], nothing, effort.Limits, effort.Depth, budget);
      }
    }
  }
}
} // namespace insideout
