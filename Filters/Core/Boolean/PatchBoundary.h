// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Boolean/PatchWindingNumbers.h"
#include "Output/BoundaryTriangles.h"
#include "Validate/FacetEdges.h"

namespace insideout
{
/**
 * Whether a rule holds on both sides of a patch: in front of PatchPlaces::FacetOf and behind it.
 */
struct HoldsBeside
{
  bool Front;
  bool Back;
};

/**
 * The facets that separate the region in which a rule holds from the rest, turned to face the rest
 * (Zhou, Grinspun, Zorin and Jacobson 2016, section 5). They are balanced on every edge.
 *
 * @param[in] surface resolved
 * @param[in] edges those of surface.Facets
 * @param[in] places of its patches
 * @param[in] holds one per patch
 * @param[in] counts one per facet: equal for two facets of a patch with the same orientation, else
 * opposite; not 0 where the rule differs
 * @return triangles by points of the surface, in the order of its facets
 * @throws Error Inconsistent if an edge is not traversed equally often both ways
 */
std::vector<BoundaryTriangle> PatchBoundary(const FacetComplex& surface, const FacetEdges& edges,
  const SurfacePatches& patches, const PatchPlaces& places, const std::vector<HoldsBeside>& holds,
  const std::vector<int>& counts);
} // namespace insideout
