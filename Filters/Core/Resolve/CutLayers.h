// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/ParallelLoop.h"
#include "Resolve/PlanarSubdivision.h"

namespace insideout
{
/**
 * All pairs, among some facets, of those that overlap nearly in one plane, nearer to it than
 * `radius`, whether they cross or not. Facets too narrow to tell their plane are passed over.
 *
 * @param[in] bodies of each facet of the surface, or none: pairs of one body are passed over
 * @throws Error (Stopped)
 */
std::vector<std::array<Id, 2>> FindLayers(const FacetList& surface, const std::vector<Id>& among,
  double radius, Monitor& monitor, const ProgressRange& progress,
  const std::vector<Id>& bodies = {});

/**
 * Cuts layers: facets that overlap nearly in one plane, nearer to it than `radius`. Where rounding
 * turned what was meant to coincide a little, such facets cross along lines that mean nothing, the
 * next cut along others. Here they are cut along each other's edges as if they were in one plane;
 * their pieces then have the same corners, and become one facet when these are placed.
 *
 * Facets too narrow to tell their plane are passed over. Facets in other planes that share an edge
 * of a layer have to be split there as its pieces are (SplitAlike).
 *
 * @param[in] pairs facets that cross, or are layers; those that are none are passed over
 * @param[in] radius in units of the points
 * @return one subdivision for every group of layers, by lowest facet; sources are facet ids
 * @throws Error (Stopped)
 */
std::vector<PlanarSubdivision> CutLayers(const FacetList& surface,
  const std::vector<std::array<Id, 2>>& pairs, double radius, Monitor& monitor,
  const ProgressRange& progress);

/**
 * Cuts facets that are meant to coincide, however far they are apart, as CutLayers does. Where two
 * edges cross the point is put on the one of the lower facet.
 *
 * @param[in] pairs facets that lie on each other
 * @return one subdivision for every group of such facets that can be seen along one axis
 * @throws Error (Stopped)
 */
std::vector<PlanarSubdivision> CutTouching(const FacetList& surface,
  const std::vector<std::array<Id, 2>>& pairs, Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
