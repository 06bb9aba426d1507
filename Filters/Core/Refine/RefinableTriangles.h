// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Planar/PlanarCurve.h"
#include "Planar/SideOfCircle.h"

#include <vector>

namespace insideout
{
/**
 * The triangles inside a curve, during refinement: constrained Delaunay before and after each step,
 * by exact predicates, and each triangle exactly positive. There are no triangles outside.
 */
class RefinableTriangles
{
public:
  struct Cell
  {
    Triangle Corners;            ///< counter-clockwise
    std::array<Id, 3> Neighbors; ///< across edge k (EdgeOf), None beyond the boundary
    std::array<Id, 3> Sources;   ///< 3 * cell + edge of the input's constraint there, None for none
    Id Near;                     ///< a cell of the input on the same side of all constraints
    Id Version = 0;              ///< number of its changes
  };

  /** An edge of a cell. */
  struct Place
  {
    Id Cell;
    int Edge; ///< None: within
  };

  /**
   * @param[in] points of the mesh, which is constrained Delaunay by the metric
   * @param[in] inside one value per cell of the mesh, 0 for cells to be left out. Constraints are
   * the edges on segments and those between inside and outside
   */
  RefinableTriangles(const std::vector<PlanarPoint>& points, const PlanarMesh& mesh,
    const std::vector<unsigned char>& inside, const PlanarMetric& metric);

  const std::vector<PlanarPoint>& Points() const { return this->Places; }
  const std::vector<Cell>& Cells() const { return this->Triangles; }
  const PlanarMetric& Metric() const { return this->Measure; }
  Id NumberOfCells() const { return static_cast<Id>(this->Triangles.size()); }

  /**
   * The cell that contains a place, or the first constraint on the straight way there from the
   * center of a cell; Cell is None if rounding blocks the way.
   */
  Place Locate(Id from, const PlanarPoint& place) const;

  /** The cells whose circumcircles contain a place within a cell: a new point there would replace
   * them. */
  struct View
  {
    std::vector<Id> Cells;
    std::vector<Place> Rim; ///< the edges around these, including constraints
    double Spacing;         ///< distance to the nearest corner
  };
  View ViewFrom(Id cell, const PlanarPoint& place) const;

  /** Insert a point within a cell or on an unconstrained edge of it. @return it, None if the place
   * is elsewhere
   */
  Id Insert(Id cell, const PlanarPoint& place);

  /** Insert a point between the ends of an edge, off it only by rounding. @return it, None if a
   * triangle would not be positive
   */
  Id Split(const Place& edge, const PlanarPoint& place);

  /** The cells that the last step changed or made. */
  const std::vector<Id>& Changed() const { return this->Fresh; }

private:
  void Set(Id cell, const Triangle& corners, const std::array<Id, 3>& neighbors,
    const std::array<Id, 3>& sources);
  void Relink(Id neighbor, Id before, Id after);
  Id AddCell(Id like);
  bool IsPositive(Id a, Id b, const PlanarPoint& place) const;
  void Restore(std::vector<Id> star);
  bool MustFlip(Id cell) const;
  int EdgeTo(Id cell, Id neighbor) const;

  std::vector<PlanarPoint> Places;
  std::vector<Cell> Triangles;
  PlanarMetric Measure;
  SideOfCircle Circle;
  std::vector<Id> Fresh;
};
} // namespace insideout
