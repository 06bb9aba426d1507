// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/FlipTwins.h"

#include "Exact/Flips.h"

namespace insideout
{
namespace
{
/** Twins are rare, so a high effort is affordable. */
constexpr FlipEffort TwinFlips = { { 0, 12 }, 2, 200 };
} // namespace

void FlipTwinsAway(ExactState& state)
{
  const FlipTarget nothing(state.Mesh);
  for (Id facet = 0; facet < static_cast<Id>(state.Facets.size()); ++facet)
  {
    const Triangle& corners = state.Facets[facet];
    for (int k = 0; k < 3; ++k)
    {
      Id cell;
      int face;
      if (state.Segments.IsSplit(state.Segments.OfFacet(facet, k)) &&
        state.Mesh.FindFace(corners[0], corners[1], corners[2], cell, face) &&
        !RemoveFace(state, cell, face, nothing, TwinFlips.Limits))
      {
        int budget = TwinFlips.Budget;
        RemoveEdgeDeeply(state, corners[k], corners[(k + 1) % 3], nothing, TwinFlips, budget);
      }
    }
  }
}
} // namespace insideout
