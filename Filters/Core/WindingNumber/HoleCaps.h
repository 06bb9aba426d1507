// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "WindingNumber/CountedBoundary.h"

namespace insideout
{
/**
 * Caps with a given boundary: a fan for each of its loops, from the corner of the loop that gives
 * the fan the least area. A long loop is first cut into arcs. Each arc with its chord gets a fan,
 * and so does the loop of the chords. A fan has two triangles fewer than its loop has edges: that
 * of a lone triangle is the triangle itself, so that the two cancel.
 *
 * @param[in] boundary of a chain of triangles
 * @return per loop or arc the triangles that are not degenerate
 */
std::vector<std::vector<CountedTriangle>> CapHoles(
  const std::vector<Point>& points, const std::vector<CountedEdge>& boundary);

/** Caps, and the points of the boundary, sorted by coordinates, between which they are. */
struct NumberedCaps
{
  std::vector<Point> Points;
  std::vector<Id> Ids; ///< of these points, where they come from
  std::vector<std::vector<CountedTriangle>> Caps;

  /** The same caps between the points where these come from. */
  std::vector<std::vector<CountedTriangle>> InIds() const;
};

/** CapHoles, the same for any numbering of the points: no two are equal. */
NumberedCaps CapHolesInOrder(
  const std::vector<Point>& points, const std::vector<CountedEdge>& boundary);

/** Triangles with the same corners as one, or none where they cancel, in the order of corners. */
std::vector<CountedTriangle> MergeTriangles(const std::vector<CountedTriangle>& triangles);

/** The chain less its caps, which has no boundary. Triangles that cancel are left out. */
std::vector<CountedTriangle> CloseChain(
  std::vector<CountedTriangle> triangles, const std::vector<std::vector<CountedTriangle>>& caps);
} // namespace insideout
