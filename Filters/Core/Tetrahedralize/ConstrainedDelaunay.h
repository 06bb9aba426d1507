// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/Statistics.h"
#include "Common/TetrahedralMesh.h"

#include <string>

namespace insideout
{
/** The tetrahedralizer. */
enum class TetrahedralizationEngine
{
  Automatic, ///< exact flips and cuts, then TetGen if facets are lost; the mesh that loses fewest
  Exact,     ///< this project's own (ExactTetrahedralization.h), in this process
  TetGen     ///< TetGen alone
};

/** The engine and its budgets. When a budget is used up, the next rung starts. */
struct ConstrainedDelaunayParameters
{
  /**
   * Wall-clock seconds for all rungs, an equal part for each. With 0 there is no clock: the exact
   * rung counts its work (TetrahedralizeExactly), so that the same input gives the same mesh
   * however busy the machine is. TetGen's process may loop, and its work cannot be counted. It then
   * has 4 s of processor time per rung, and 0.3 ms per point and facet: many times its usual need.
   */
  double TimeBudget = 0;

  /**
   * MiB. 0 stands for 1024, plus 16 KiB per point and facet (five times TetGen's usual memory), but
   * at most three quarters of the machine's memory. Enforced for TetGen's process, not for the
   * exact rung.
   */
  double MemoryBudget = 0;

  TetrahedralizationEngine Engine = TetrahedralizationEngine::Automatic;
};

/** Tetrahedra and how they were found. */
struct Tetrahedralization
{
  TetrahedralMesh Mesh;
  int Rung = 0; ///< that the mesh comes from, counted from 1 (RungName in Ladder.h)
  std::vector<std::string> Failures; ///< reasons of the failed rungs
  /// number of hulls (TetrahedralizeApart.h); with several, Rung is the last rung that any took
  Id Parts = 1;
};

/**
 * Stage CDT: tetrahedra of the convex hull of the complex in which every constraint is a union of
 * faces (thesis, chapter 8).
 *
 * TetrahedralizeExactly kept all facets of 145 real, mostly difficult surfaces, with Steiner points
 * of 0.09 % of the points at the median and below 1.9 % on nine in ten. TetGen's first way failed
 * on 16 of these. On the other 129 both take about as long, at the median and in sum; the exact way
 * takes up to eight times as long where flips leave many edges to be cut. It takes a quarter of an
 * hour for one surface of 600,000 facets that TetGen cannot do. TetGen runs in a separate program
 * (TetgenProcess.h), because it exits, crashes or loops on some inputs. The result of either is
 * checked (AssembleMesh.h): points in place, exact positive volumes, every face shared by at most
 * two cells, the hull convex, facets present.
 *
 * If one rung fails the next on the ladder is tried (Ladder.cxx lists them). The last is the
 * Delaunay tetrahedralization of the points without regard to facets. Among meshes that lose facets
 * the one that loses fewest is taken; it names them in LostFacets.
 *
 * Every point of the complex is a point of the mesh, whether a constraint uses it or not.
 *
 * The same input gives the same mesh, unless TetGen's process or, with a TimeBudget, any rung takes
 * about as long as it may.
 *
 * @param[in] surface a complex whose constraints do not cross, with no point in the interior of a
 *            constraint or of its edges; if they do cross facets are lost
 * @throws Error EmptySurface, PointOutOfRange, PointNotFinite, Planar, InvalidParameter, Stopped;
 *         TetrahedralizerFailed when even the points alone take more than the memory budget
 */
Tetrahedralization ConstrainedDelaunay(
  const FacetComplex& surface, const ConstrainedDelaunayParameters& parameters, Monitor& monitor);

/** The mesh alone, with the default budgets. */
TetrahedralMesh ConstrainedDelaunay(const FacetComplex& surface, Monitor& monitor);

/** Where the mesh comes from and its sizes, for `statistics`. */
void AddMeshCounts(const Tetrahedralization& result, Statistics& statistics);

/**
 * List the failed rungs with their reasons, a line each, and the rung that the mesh comes from;
 * empty if the first rung sufficed.
 */
void AddWarnings(const Tetrahedralization& result, std::vector<std::string>& warnings);
} // namespace insideout
