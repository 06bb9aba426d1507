// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/ParallelLoop.h"
#include "Resolve/PlanarSubdivision.h"

namespace insideout
{
/**
 * All pairs of some facets that overlap nearly in one plane, within `radius` of it, crossing or
 * not. Facets too narrow to define a plane are skipped.
 *
 * @param[in] bodies one per facet among these, or empty: pairs of one body are skipped
 * @throws Error (Stopped)
 */
std::vector<std::array<Id, 2>> FindLayers(const FacetList& surface, const std::vector<Id>& among,
  double radius, Monitor& monitor, const ProgressRange& progress,
  const std::vector<Id>& bodies = {});

/**
 * Cuts layers: facets that overlap nearly in one plane, nearer to it than `radius`. If rounding has
 * turned facets that should coincide, they cross along meaningless lines, and along others after
 * the next cut. Here they are cut along each other's edges as if they were in one plane; their
 * pieces then have the same corners, and become one facet when these are placed.
 *
 * Facets too narrow to define a plane are skipped. Facets in other planes that share an edge
 * of a layer have to be split there as its pieces are (SplitAlike).
 *
 * @param[in] pairs facets that cross, or are layers; other pairs are skipped
 * @param[in] radius in units of the points
 * @return one subdivision for every group of layers, by lowest facet; sources are facet ids
 * @throws Error (Stopped)
 */
std::vector<PlanarSubdivision> CutLayers(const FacetList& surface,
  const std::vector<std::array<Id, 2>>& pairs, double radius, Monitor& monitor,
  const ProgressRange& progress);

/**
 * Cut facets that are meant to coincide, as CutLayers does, whatever their distance. If two edges
 * cross, the point lies on the edge of the lower facet.
 *
 * @param[in] pairs facets that lie on each other
 * @return one subdivision for every group of such facets that can be seen along one axis
 * @throws Error (Stopped)
 */
std::vector<PlanarSubdivision> CutTouching(const FacetList& surface,
  const std::vector<std::array<Id, 2>>& pairs, Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
