// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Refine/RefinableMesh.h"

#include <vector>

namespace insideout
{
/**
 * How good a tetrahedron is: the square of the least sine of its six dihedral angles, which is
 * small where an angle is near 0 or near 180 degrees; at most 8/9, of a regular one. Not positive
 * where the volume is not.
 */
double ShapeOf(const Point& a, const Point& b, const Point& c, const Point& d);
double ShapeOf(const std::vector<Point>& points, const Tetrahedron& cell);

/** The worst shape of some cells, at most 1. */
double WorstShapeOf(const RefinableMesh& mesh, const std::vector<Id>& cells);

/** A face, and what cells on its positive side have in common, to try many fourth corners. */
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
  double Inverse; ///< of the square of the normal
};

/** The shape whose least dihedral angle has this many degrees. */
double ShapeOfAngle(double degrees);

Point Barycentre(const std::vector<Point>& points, const Tetrahedron& cell);

/** Where all four corners are equally far, and the square of how far. */
struct Circumsphere
{
  Point Center;
  double SquaredRadius; ///< not finite where the cell is too flat for doubles
};
Circumsphere CircumsphereOf(const Point& a, const Point& b, const Point& c, const Point& d);

/** The circumcenter of a triangle in its plane, and the squared radius.
 */
struct CircleOfTriangle
{
  Point Center;
  double SquaredRadius; ///< not finite where it is too thin for doubles
};
CircleOfTriangle CircumcircleOf(const std::array<Point, 3>& triangle);
} // namespace insideout
