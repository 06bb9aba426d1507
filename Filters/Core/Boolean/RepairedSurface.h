// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Boolean/PatchBoundary.h"
#include "GraphCut/CutEnergy.h"
#include "Output/Outliers.h"

#include <optional>

namespace insideout
{
/** What a closed surface bounds. */
struct RepairedSurface
{
  std::vector<BoundaryTriangle> Boundary; ///< by points of the surface, in the order of its facets
  std::vector<OutlierPiece> Outliers;     ///< facets with no inside on either side
  int MinimumW = 0;                       ///< of all places, 0 far away
  int MaximumW = 0;
};

/**
 * The boundary of the solid that a closed surface means, without any tetrahedra: the facets across
 * which w becomes 1 or more, by the winding numbers on both sides of each patch. Self-intersections
 * and inner walls are gone. It is watertight, and no two of its triangles meet but in shared points
 * and edges.
 *
 * The solid is the one that the cut gives with weights that IsCutByWholeNumbers is true for.
 *
 * @param[in] surface resolved
 * @return nothing where the surface is open, or a facet was left out in resolving: then w, or where
 *   it changes, takes a mesh
 * @throws Error (Stopped)
 */
std::optional<RepairedSurface> RepairSurface(const FacetComplex& surface, Monitor& monitor);

/**
 * Whether a cut with these weights is known to take the cells with w of 1 or more, where w is a
 * whole number in each: no weight is above the defaults', for which CutEnergy.h has the proof.
 */
bool IsCutByWholeNumbers(const GraphCutParameters& cut);
} // namespace insideout
