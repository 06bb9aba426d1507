// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Refine/RefinableSurface.h"
#include "Refine/SurfacePiece.h"
#include "Refine/TriangleTree.h"

#include <vector>

namespace insideout
{
/**
 * The facets with pieces on the boundary that meet others beyond shared corners and edges: a
 * surface that moves, if only by rounding, may touch a part next to it.
 *
 * @throws Error Stopped
 */
std::vector<Id> CrossingFacets(
  const RefinableMesh& mesh, Monitor& monitor, const ProgressRange& progress);

/**
 * Set the facets of all pieces to the nearest ones of the same label.
 *
 * @throws Error Stopped
 */
void FindNearestFacets(const std::vector<FacetOfInput>& facets, RefinableMesh& mesh,
  Monitor& monitor, const ProgressRange& progress);

/**
 * The distance of the first surface's points from the second, as far as samples tell
 * (TriangleTree::LargestDistanceOf).
 *
 * @throws Error Stopped
 */
double LargestDistance(const std::vector<LabelledTriangle>& from,
  const std::vector<LabelledTriangle>& to, double enough, Monitor& monitor,
  const ProgressRange& progress);
} // namespace insideout
