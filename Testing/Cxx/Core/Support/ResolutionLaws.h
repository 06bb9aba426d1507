// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Resolve/ResolveSelfIntersections.h"

#include <string>
#include <vector>

/**
 * An independent judge of the resolver: it shares no predicate with it, and knows of the result
 * only what the interface says. Works on real models: exact where it decides, in long double where
 * it measures, on all threads.
 */
namespace testmeshes
{
using namespace insideout;

/** Measures of a resolved surface against its original. */
struct ResolutionJudgement
{
  Id Crossings = 0;   ///< pairs of constraints that meet in more than shared points and edges
  Id LeftOut = 0;     ///< facets behind NumberOfConstraints that were constraints before
  double Offset = 0;  ///< how far a piece's corner is at most from its facet, over the size
  double Area = 0;    ///< by how much a facet's area and its pieces' differ at most, over the size
                      ///< times the facet's perimeter
  double Winding = 0; ///< by how much w differs at most at the points tried
  int WindingPoints = 0;               ///< how many were tried
  std::vector<std::string> Violations; ///< a line for each law that is broken, naming a culprit
};

/** The size that tolerances refer to: the largest coordinate in absolute value. */
double SizeOf(const std::vector<Point>& points);

/**
 * Judge a resolved surface. Its laws:
 * - No two constraints meet except in shared points and edges (IntersectionsBySweep).
 * - No point lies within a constraint or an edge of one (LiesWithinByClipping).
 * - No facet is degenerate, or there twice.
 * - Input points come first, bit by bit, and so do their origins. New points are corners.
 * - Pieces of a facet are within 1e-12 of the size of it; their area is its area, to what that
 *   allows along its perimeter; and, unless facets were left out, the edges of exactly
 *   one of its pieces are on its boundary: there is no gap.
 * - A piece has all sources of the facets that it is part of, turned as these say, and counts as
 * often as they together.
 * - Where all facets close (every edge's signed sum is 0), they still do, unless some were left
 * out.
 * - Facets that were no constraints before come last, as they were.
 * - w is the same to 1e-9 at random points not nearer than 1e-6 of the size to a facet that was
 * cut.
 *
 * @param[in] before no two facets have a source in common
 * @param[in] windingPoints how many points to try
 */
ResolutionJudgement JudgeResolution(
  const FacetComplex& before, const FacetComplex& after, int windingPoints);

/** Whether two complexes are the same, bit by bit. */
bool SameBytes(const FacetComplex& a, const FacetComplex& b);
} // namespace testmeshes
