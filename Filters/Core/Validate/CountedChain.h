// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "Common/Monitor.h"
#include "Common/Statistics.h"
#include "Validate/CoarseCoordinates.h"
#include "Validate/FacetEdges.h"

#include <string>

namespace insideout
{
struct CountedChainParameters
{
  /** Points at most this far apart become one, in units of the surface. 0: only equal points do. */
  double MergeTolerance = 0;
  /** Count a triangle as often as it is given, instead of as often as closed shells need it. */
  bool CountDuplicates = false;
};

/** What validation found; the columns |V|, |F|, |dF|, #CC and #nme. of the thesis's table 8.1 too.
 */
struct SurfaceCounts
{
  Id InputPoints = 0;
  Id InputTriangles = 0;
  Id Points = 0;                 ///< that valid facets use, after merging
  Id Facets = 0;                 ///< that are not degenerate, each counted once
  Id MergedPoints = 0;           ///< input points that became one with a point of lower id
  Id DegenerateFacets = 0;       ///< left out: two equal corners, or all three on a line
  Id DuplicateFacets = 0;        ///< input triangles whose three points an earlier one has
  Id SharedFacets = 0;           ///< of these: count again, for several closed shells have them
  Id CancelledFacets = 0;        ///< facets given in both orientations, which count 0
  Id OpenEdges = 0;              ///< edges of exactly one facet
  double OpenLength = 0;         ///< of these edges, all together
  double Diagonal = 0;           ///< of the box around all points in use
  Id NonManifoldEdges = 0;       ///< edges of more than two facets
  Id Components = 0;             ///< of facets joined through edges
  Id TwoSidedSolids = 0;         ///< two-sided components that close a volume: kept once
  Id TwoSidedSheets = 0;         ///< two-sided components that close none: constraints that count 0
  Id NonParticipatingFacets = 0; ///< no triangle of which participates: constraints that count 0
};

struct CountedChain
{
  FacetComplex Surface;         ///< only points that a facet uses, in the input's order
  std::vector<FacetEdge> Edges; ///< those of Surface.Facets
  SurfaceCounts Counts;
  CoarseCoordinates Coordinates;
  std::vector<std::string> Warnings;
  std::vector<Id> MergedInto;          ///< per point of the soup the one that it became, or itself
  std::vector<Id> DegenerateTriangles; ///< of the soup: left out; ascending
};

/**
 * Stage validate: the facets that count, and how often, out of whatever was given.
 *
 * Points with equal coordinates become one (-0 equals +0; the lowest id's bits stay). Degenerate
 * triangles are left out. Triangles with the same three points become one facet, whose multiplicity
 * counts them as often as closed shells need them (CountCopies.h), else once per orientation,
 * opposite ones cancelling; it stays a constraint at 0. Where a whole component cancels, it is
 * two-sided: if it closes a volume when kept once, it is, turned outward. None of this is for a
 * soup that comes with multiplicities: those of equal triangles add.
 *
 * Triangles that do not participate (thesis, section 8.7) become constraints like the others, but
 * add nothing: they neither cancel one that does, nor join components, nor make one two-sided.
 *
 * @throws Error EmptySurface, PointNotFinite, PointOutOfRange, AllDegenerate, InvalidParameter,
 *         TooLarge, Stopped; triangles and points are named by their index in `soup`
 */
CountedChain CountFacets(
  const TriangleSoup& soup, const CountedChainParameters& parameters, Monitor& monitor);

/** The counts under their names, for `statistics`. */
void AddCounts(const SurfaceCounts& counts, Statistics& statistics);
} // namespace insideout
