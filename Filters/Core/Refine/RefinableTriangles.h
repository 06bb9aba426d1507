// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Planar/PlanarCurve.h"
#include "Planar/SideOfCircle.h"

#include <vector>

namespace insideout
{
/**
 * The triangles inside a curve, to be refined: constrained Delaunay before and after each step, by
 * exact predicates, and each triangle positive, exactly. There are no triangles outside.
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
    Id Version = 0;              ///< counts its changes
  };

  /** An edge, as a cell has it. */
  struct Place
  {
    Id Cell;
    int Edge; ///< None: within
  };

  /**
   * @param[in] points of the mesh, which is constrained Delaunay by the metric
   * @param[in] inside one value per cell of the mesh, 0 for those to be left out. Constraints are
   *   the edges on segments and those between inside and outside
   */
  RefinableTriangles(const std::vector<PlanarPoint>& points, const PlanarMesh& mesh,
    const std::vector<unsigned char>& inside, const PlanarMetric& metric);

  const std::vector<PlanarPoint>& Points() const { return this->Places; }
  const std::vector<Cell>& Cells() const { return this->Triangles; }
  const PlanarMetric& Metric() const { return this->Measure; }
  Id NumberOfCells() const { return static_cast<Id>(this->Triangles.size()); }

  /**
   * The cell that holds a place, or the first constraint on the straight way there from the middle
   * of a cell; Cell is None where rounding leaves no way.
   */
  Place Locate(Id from, const PlanarPoint& place) const;

  /** What a place within a cell sees: the cells whose circles it is in, which those of a new point
   * there would replace. */
  struct View
  {
    std::vector<Id> Cells;
    std::vector<Place> Rim; ///< the edges around these; constraints are among them
    double Spacing;         ///< to the nearest corner
  };
  View ViewFrom(Id cell, const PlanarPoint& place) const;

  /** A new point within a cell or on an edge of it that is no constraint. @return it, None where it
   * is no such place */
  Id Insert(Id cell, const PlanarPoint& place);

  /** A new point between the ends of an edge, off it only by rounding. @return it, None where a
   * triangle would not be positive */
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
