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
  /** Points at most this far apart are merged, in units of the surface. 0: only equal points. */
  double MergeTolerance = 0;
  /** Count a triangle as often as it is given, instead of as often as closed shells need it. */
  bool CountDuplicates = false;
};

/** The result of validation, including the columns |V|, |F|, |dF|, #CC and #nme. of the thesis's
 * table 8.1. */
struct SurfaceCounts
{
  Id InputPoints = 0;
  Id InputTriangles = 0;
  Id Points = 0;           ///< points used by valid facets, after merging
  Id Facets = 0;           ///< facets that are not degenerate, each counted once
  Id MergedPoints = 0;     ///< input points merged with a point of lower id
  Id DegenerateFacets = 0; ///< left out: two equal corners, or all three on a line
  Id DuplicateFacets = 0;  ///< input triangles with the same three points as an earlier one
  /// of these, counted again, because several closed shells contain them
  Id SharedFacets = 0;
  Id CancelledFacets = 0;  ///< facets given in both orientations, which count 0
  Id OpenEdges = 0;        ///< edges of exactly one facet
  double OpenLength = 0;   ///< total length of these edges
  double Diagonal = 0;     ///< diagonal of the box around all points in use
  Id NonManifoldEdges = 0; ///< edges of more than two facets
  Id Components = 0;       ///< of facets joined through edges
  Id TwoSidedSolids = 0;   ///< two-sided components that close a volume: kept once
  /// two-sided components that close no volume: constraints that count 0
  Id TwoSidedSheets = 0;
  /// components without a participating triangle: constraints that count 0
  Id NonParticipatingFacets = 0;
};

struct CountedChain
{
  FacetComplex Surface; ///< only points that a facet uses, in the input's order
  FacetEdges Edges;     ///< those of Surface.Facets
  SurfaceCounts Counts;
  CoarseCoordinates Coordinates;
  std::vector<std::string> Warnings;
  /// per point of the soup the point that it was merged with, or itself
  std::vector<Id> MergedInto;
  std::vector<Id> DegenerateTriangles; ///< of the soup: left out; ascending
};

/**
 * Stage validate: the facets of any input, with their counts.
 *
 * Points with equal coordinates are merged (-0 equals +0; the lowest id's bits stay). Degenerate
 * triangles are left out. Triangles with the same three points become one facet. Its multiplicity
 * counts them as often as closed shells need them (CountCopies.h), else once per orientation;
 * opposite ones cancel. With multiplicity 0 it stays a constraint. If a whole component cancels, it
 * is two-sided: if it closes a volume when kept once, it is kept so, turned outward. None of this
 * applies to a soup with multiplicities: those of equal triangles add.
 *
 * Triangles that do not participate (thesis, section 8.7) become constraints like the others, but
 * do not count: they neither cancel participating ones, nor join components, nor make one
 * two-sided.
 *
 * @throws Error EmptySurface, PointNotFinite, PointOutOfRange, AllDegenerate, InvalidParameter,
 *         TooLarge, Stopped; triangles and points are named by their index in `soup`
 */
CountedChain CountFacets(
  const TriangleSoup& soup, const CountedChainParameters& parameters, Monitor& monitor);

/** The counts by name, for `statistics`. */
void AddCounts(const SurfaceCounts& counts, Statistics& statistics);
} // namespace insideout
