// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "Common/Monitor.h"

#include <string>
#include <vector>

namespace insideout
{
struct Resolution
{
  FacetComplex Surface;
  std::vector<std::array<Id, 2>> IntersectingPairs; ///< facets of the input complex, sorted
  int Rounds = 0; ///< number of rounds of cutting: more than 1 if rounding made new crossings
  std::vector<std::string> Warnings; ///< of tangles whose facets were bent
};

/** Crossings of a complex that were found before. */
struct KnownCrossings
{
  /** One per facet, or empty where none are known: within each set all are. */
  std::vector<Id> SetOf;

  /** The facets that may meet one of another set (FacetsNearOthers), ascending. */
  std::vector<Id> NearOthers;

  /** Pairs (i, j) with i < j of facets that meet beyond shared corners and edges. */
  std::vector<std::array<Id, 2>> Pairs;
};

/** Facets that are meant to coincide where they lie on each other. */
struct TouchingFacets
{
  std::vector<std::array<Id, 2>> Pairs;
  double Radius = 0; ///< their largest distance
};

/**
 * Stage pre: cut facets where they meet other than in shared points and edges, until none do (the
 * pre-processing of thesis, chapter 8). Cutting is exact. Then new points are rounded to doubles,
 * slivers are collapsed, and facets that cross afterwards are cut again. Layers that cross because
 * they coincide only up to rounding are merged first. Each tangle (FindTangles) is joined in a
 * point, with a warning. Input points keep their coordinates and come first, in their order. No
 * point, not even an unused one, lies within a constraint or an edge of one.
 *
 * Pieces that coincide become one facet with all sources and the sum of the multiplicities. If
 * rounding folds a triangle onto itself, its opposite pieces cancel. Facets that still cross after
 * the last round follow Surface.NumberOfConstraints.
 *
 * @param[in] surface a validated complex; move it here where it is needed no more
 * @param[in] known is not searched again
 * @param[in] touching facets are merged along each other's edges, as if they were in one plane.
 * Points of the surface stay; the first facet of a pair keeps its shape, and the second is bent to
 * it
 * @param[in] mayTouch facets that are merged if they coincide up to rounding, even if none of them
 * cross; they take a search of their own
 * @throws Error TooLarge if facets coincide more often than a multiplicity can count, Stopped
 */
Resolution ResolveSelfIntersections(FacetComplex surface, Monitor& monitor,
  const KnownCrossings& known = {}, const TouchingFacets& touching = {},
  const std::vector<Id>& mayTouch = {});
} // namespace insideout
