// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Boolean/PatchWindingNumbers.h"
#include "Output/BoundaryTriangles.h"
#include "Validate/FacetEdges.h"

namespace insideout
{
/** Whether a rule holds on both sides of a patch: in front of and behind PatchPlaces::FacetOf. */
struct HoldsBeside
{
  bool Front;
  bool Back;
};

/**
 * The facets across which a rule begins or ends to hold, turned to face where it does not (Zhou,
 * Grinspun, Zorin and Jacobson 2016, section 5). They are balanced on every edge.
 *
 * @param[in] surface resolved
 * @param[in] edges those of surface.Facets
 * @param[in] places of its patches
 * @param[in] holds one per patch
 * @param[in] counts one per facet: of two of a patch the same where they run the same way, else the
 *   opposite; not 0 where the rule differs
 * @return triangles by points of the surface, in the order of its facets
 * @throws Error Inconsistent where an edge is not run through as often one way as the other
 */
std::vector<BoundaryTriangle> PatchBoundary(const FacetComplex& surface,
  const std::vector<FacetEdge>& edges, const SurfacePatches& patches, const PatchPlaces& places,
  const std::vector<HoldsBeside>& holds, const std::vector<int>& counts);
} // namespace insideout
