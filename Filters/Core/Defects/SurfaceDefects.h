// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Statistics.h"
#include "Defects/SampledVolumes.h"
#include "Orient/OrientFacets.h"
#include "Validate/CountedChain.h"

namespace insideout
{
/** The defects of an input triangle. The triangles of one facet (CountedChain.h) differ in
 * Duplicate only. */
struct TriangleDefects
{
  /// component of facets joined through edges, numbered by first triangle; degenerate: None
  Id Component = None;
  Id Shell = None;          ///< shell (Shells.h); None if it counts 0
  Id SelfIntersections = 0; ///< number of facets that it meets beyond shared corners and edges
  bool Degenerate = false;
  bool Duplicate = false;    ///< an earlier triangle has the same three points
  bool Inconsistent = false; ///< has an edge of DefectType::InconsistentEdge
  bool TwoSided = false;     ///< belongs to a component given in both orientations everywhere
  bool Turned = false;       ///< to be turned over (OrientFacets.h)
  bool Sheet = false;        ///< belongs to a shell that encloses nothing (OrientFacets.h)
  bool Membrane = false;     ///< belongs to a sheet within the solid or across it (Membranes.h)
};

enum class DefectType
{
  OpenBoundary,     ///< edges of exactly one facet
  NonManifoldEdge,  ///< edges of more than two facets
  InconsistentEdge, ///< edges along which two facets, and no others, run the same way
  IntersectionCurve ///< where facets cross, touch, or begin to overlap
};

/** A polyline; a single point where facets only touch. A closed one repeats its first point. */
struct DefectLine
{
  DefectType Type;
  std::vector<Id> Points;
};

struct SurfaceDefects
{
  std::vector<TriangleDefects> Triangles; ///< one per input triangle

  std::vector<Point> Points;     ///< of the lines
  std::vector<Id> InputPoints;   ///< the input point of each, None for a new one
  std::vector<DefectLine> Lines; ///< number by type

  SurfaceCounts Counts;
  FacetTurns Turns;       ///< triangles to be turned over by the orientation
  SampledVolumes Volumes; ///< volume after these turns; 0 if all facets lie in one plane
  Id IntersectingPairs = 0;
  Id IntersectingFacets = 0; ///< number of facets in at least one pair
  Id InconsistentEdges = 0;
  Id UnbalancedEdges = 0;  ///< edges at which the counted facets' signed sum is not 0; none: closed
  bool Planar = false;     ///< all facets lie in one plane
  Id NearPoints = 0;       ///< points nearer to another than NearDistance, after merging
  double NearDistance = 0; ///< a millionth of the diagonal of the bounding box

  std::vector<std::string> Warnings; ///< advice, apart from the counts
};

/**
 * Find the defects of a surface: the columns of the thesis's table 8.1, at the places drawn in its
 * figure 8.22. Facets and edges are those of the counted chain, before anything is cut or turned.
 * Edges are judged by the facets' counts: a facet given in both orientations counts 0, and agrees
 * with any neighbor.
 *
 * @param[in] mergeTolerance as in CountedChainParameters
 * @throws Error as CountFacets does
 */
SurfaceDefects FindSurfaceDefects(
  const TriangleSoup& soup, double mergeTolerance, Orientation orientation, Monitor& monitor);

/** The counts by name, for `statistics`. */
void AddDefects(const SurfaceDefects& defects, Statistics& statistics);
} // namespace insideout
