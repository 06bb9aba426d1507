// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/Statistics.h"
#include "Layers/LayerParameters.h"
#include "Planar/FindPlane.h"
#include "Planar/PlanarCurve.h"

#include <array>
#include <vector>

namespace insideout
{
/** Corners counter-clockwise: at the wall, then behind. */
using Quad = std::array<Id, 4>;

/** Triangles with layers of quads at a wall, of triangles where one side has no length. */
struct PlanarLayeredMesh
{
  /** An edge of the boundary. */
  struct BoundaryEdge
  {
    Segment Ends; ///< the triangles are on its left
    Id Edge;      ///< of the input, 3 * cell + edge: one with the same label
  };

  std::vector<PlanarPoint> Points;
  std::vector<Id> OriginalPoints; ///< per point, its number in the input; None for a new one
  std::vector<Id> CellsOfPoints;  ///< per point, an input cell that contains it or is near it

  std::vector<Triangle> Triangles; ///< counter-clockwise; those behind the layers first
  std::vector<Quad> Quads;

  /** Per cell, triangles before quads: an input cell that contains it or is near it, and its layer:
   * 1 at the wall, 0 behind the layers. */
  std::vector<Id> OriginalCells;
  std::vector<Id> Layers;

  std::vector<BoundaryEdge> Boundary;
  insideout::Statistics Statistics;
};

/**
 * Layers of quads inside a part of the boundary of triangles in a plane, whose edges stay bit by
 * bit: MakeBoundaryLayers with one dimension less. At each point of the wall all layers shrink by
 * the same factor where room is missing. They shrink to 0 at other constraints, but for straight
 * parts of one label of the boundary, along which they continue: these get the layers' sides, and
 * their points there go. A quad that loses a side is a triangle.
 *
 * The moved wall, the layers' sides and all other constraints cross nothing, and no layer contains
 * a point of them, by exact predicates: heights are halved until this holds, and 0 from the eighth
 * time on. Behind the layers the points of the input stay, but for those close to the moved wall,
 * in a constrained Delaunay triangulation that is refined (RefineTriangles, kept). Every cell is
 * positive at its corners, exactly. The result is deterministic.
 *
 * Statistics: Layers, Quads, LayerTriangles; WallEdges, WallPoints, ReducedPoints, BarePoints,
 * NarrowPoints, EndPoints, FullHeightShare and MeanHeightShare as MakeBoundaryLayers has them;
 * MinAngle, Angle1Percent and MaxAngle of the triangles behind.
 *
 * @param[in] points in the plane's coordinates
 * @param[in] mesh triangles of the solid alone, positive; its Segments are labels of constraints,
 * None where there is none, and every edge without a second triangle has one
 * @param[in] wall edges without a second triangle, 3 * cell + edge, ascending
 * @param[in] parameters heights are in the units of the plane's points
 * @throws Error InvalidParameter for parameters out of range; SelfIntersecting if constraints cross
 * or triangles overlap; TooLarge; Stopped
 */
PlanarLayeredMesh MakePlanarLayers(const std::vector<PlanarPoint>& points, const PlanarMesh& mesh,
  const std::vector<Id>& wall, const Plane& plane, const LayerParameters& parameters,
  Monitor& monitor);
} // namespace insideout
