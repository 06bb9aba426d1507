// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Refine/RefinableMesh.h"

#include <vector>

namespace insideout
{
/**
 * The quality of a tetrahedron: the square of the least sine of its six dihedral angles. It is
 * small if an angle is near 0 or 180 degrees, at most 8/9 (for a regular tetrahedron), and not
 * positive if the volume is not.
 */
double ShapeOf(const Point& a, const Point& b, const Point& c, const Point& d);
double ShapeOf(const std::vector<Point>& points, const Tetrahedron& cell);

/** The worst shape of some cells, at most 1. */
double WorstShapeOf(const RefinableMesh& mesh, const std::vector<Id>& cells);

/**
 * A face with precomputed values for cells on its positive side, for trying many fourth corners.
 */
class BaseOfCells
{
public:
  BaseOfCells(const Point& a, const Point& b, const Point& c);

  /** ShapeOf(a, b, c, d). */
  double ShapeWith(const Point& d) const;

private:
  Point A;
  Point B;
  Point C;
  Point AB;
  Point AC;
  Point BC;
  Point Normal;
  double SquaredAB;
  double SquaredAC;
  double SquaredBC;
  double Inverse; ///< squared length of the normal
};

/** The shape of a cell whose least dihedral angle has this many degrees. */
double ShapeOfAngle(double degrees);

Point Barycentre(const std::vector<Point>& points, const Tetrahedron& cell);

/** A circumcenter, of a triangle in its plane, and the squared radius. */
struct Circumsphere
{
  Point Center;
  double SquaredRadius; ///< not finite if the cell or triangle is too flat for doubles
};
Circumsphere CircumsphereOf(const Point& a, const Point& b, const Point& c, const Point& d);
Circumsphere CircumcircleOf(const std::array<Point, 3>& triangle);
} // namespace insideout
