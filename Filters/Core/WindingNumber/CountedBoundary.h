// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"

#include <cstdint>
#include <vector>

namespace insideout
{
/** A triangle between points of some list, and its count along its orientation. */
struct CountedTriangle
{
  Triangle Corners;
  int Count;
};

/** Such triangles, and for each the facet of a complex that it belongs to. */
struct ChainOfFacets
{
  std::vector<CountedTriangle> Triangles;
  std::vector<Id> Facets;
};

/** The facets of a complex that count, in its order. */
std::vector<CountedTriangle> CountedFacets(const FacetComplex& surface);

/** The center of each triangle. */
std::vector<Point> CentresOf(
  const std::vector<Point>& points, const std::vector<CountedTriangle>& triangles);

/** An edge from one point to another, and its count in that direction. */
struct CountedEdge
{
  Id From;
  Id To;
  std::int64_t Count;
};

/**
 * The boundary of a chain of triangles: each edge with a signed sum other than zero, once, from its
 * lower to its higher point, sorted by From, then To.
 *
 * @param[in] numberOfPoints above every corner's number
 */
std::vector<CountedEdge> CountedBoundary(
  const std::vector<CountedTriangle>& triangles, Id numberOfPoints);

/** A closed walk along edges; the first point is not repeated at the end. */
using Loop = std::vector<Id>;

/**
 * Cut a boundary into loops that pass no point twice; an edge that counts n times is in n of them.
 *
 * @param[in] boundary of a chain, so that as many edges enter each point as leave it
 */
std::vector<Loop> LoopsOf(const std::vector<CountedEdge>& boundary);
} // namespace insideout
