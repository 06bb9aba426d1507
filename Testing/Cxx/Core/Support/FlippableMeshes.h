// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/ExactState.h"

/** Meshes for the operators that change them. */
namespace testflips
{
using namespace insideout;

/** A budget that is never used up. */
WorkBudget& AnyWork();

/** A monitor that stops nothing. */
Monitor& AnyMonitor();

/** The Delaunay tetrahedralization. */
FlippableMesh DelaunayMesh(const std::vector<Point>& points, WorkBudget& work = AnyWork());

/**
 * The mesh of just these cells, which fill the convex hull of their points. Corners may come in any
 * order.
 */
FlippableMesh MeshOfCells(const std::vector<Point>& points, const std::vector<Tetrahedron>& cells);

/** A cell for each triangle and each apex, as in a pyramid on either side. */
std::vector<Tetrahedron> Pyramids(
  const std::vector<Triangle>& triangles, const std::vector<Id>& apexes);

/** Different points with whole coordinates below `size` that span space, many of them in a plane.
 */
std::vector<Point> GridPoints(std::mt19937& random, int count, int size);

/** Points in the unit cube. */
std::vector<Point> RandomPoints(std::mt19937& random, int count);

/** Grid points for odd seeds, others for even ones. */
std::vector<Point> AnyPoints(unsigned seed, int count);

/** A mesh with facets among its faces. */
struct MeshWithFacets : ExactState
{
  /** Mark those of the facets that are faces. */
  MeshWithFacets(FlippableMesh mesh, std::vector<Triangle> facets, Monitor& monitor = AnyMonitor());

  /** How near a new point is to its neighbors. In sevenths there are few doubles. */
  struct Weights
  {
    double First = 4;
    double Second = 3;
  };

  /** Put a vertex on an edge, exactly between its ends; facets and segments there are split. */
  Id SplitEdge(Id u, Id v, const Weights& weights);
  Id SplitEdge(Id u, Id v) { return this->SplitEdge(u, v, {}); }

  /** Put a vertex on a face, exactly between its corners; a facet there is split. */
  Id SplitFace(const MeshFace& face);

  /** Put a vertex in the middle of a cell, up to rounding. @return None where that is outside */
  Id SplitCell(Id cell);

  /** Flip faces and edges that are no constraints at random. */
  void FlipAtRandom(std::mt19937& random, int tries);
};

/** The Delaunay mesh of any points, with every n-th face a facet. */
MeshWithFacets RandomMeshWithFacets(
  unsigned seed, int points, unsigned facesPerFacet, WorkBudget& work = AnyWork());

/** Random facets that meet in shared corners and edges only; no other point is on any of them. */
std::vector<Triangle> FacetsThatDoNotMeet(
  const std::vector<Point>& points, std::mt19937& random, int tries);

/** The live cells without the vertex at infinity. */
std::vector<Id> FiniteCells(const FlippableMesh& mesh);
} // namespace testflips
