// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/CellShape.h"

#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
BaseOfCells::BaseOfCells(const Point& a, const Point& b, const Point& c)
  : A(a)
  , B(b)
  , C(c)
  , AB(Difference(b, a))
  , AC(Difference(c, a))
  , BC(Difference(c, b))
  , Normal(Cross(this->AB, this->AC))
  , SquaredAB(Dot(this->AB, this->AB))
  , SquaredAC(Dot(this->AC, this->AC))
  , SquaredBC(Dot(this->BC, this->BC))
  , Inverse(1 / Dot(this->Normal, this->Normal))
{
}

double BaseOfCells::ShapeWith(const Point& d) const
{
  const Point ad = Difference(d, this->A);
  const double determinant = Dot(this->Normal, ad);
  if (!(determinant > 0))
  {
    return determinant;
  }
  const Point bd = Difference(d, this->B);
  const Point cd = Difference(d, this->C);
  const Point acrossB = Cross(this->AC, ad);
  const Point acrossC = Cross(ad, this->AB);
  const Point acrossA = Cross(this->BC, bd);
  const double inverseA = 1 / Dot(acrossA, acrossA);
  const double inverseB = 1 / Dot(acrossB, acrossB);
  const double inverseC = 1 / Dot(acrossC, acrossC);
  // The sine at an edge is 3/2 volume times the edge's length over the areas of its two faces.
  const double least = std::min(
    { this->SquaredAB * (inverseC * this->Inverse), this->SquaredAC * (inverseB * this->Inverse),
      Dot(ad, ad) * (inverseB * inverseC), this->SquaredBC * (inverseA * this->Inverse),
      Dot(bd, bd) * (inverseA * inverseC), Dot(cd, cd) * (inverseA * inverseB) });
  const double shape = determinant * determinant * least;
  // NaN if a face has no area; too large if products under- or overflow.
  return shape > 0 && shape < 1 ? shape : 0.0;
}

double ShapeOf(const Point& a, const Point& b, const Point& c, const Point& d)
{
  return BaseOfCells(a, b, c).ShapeWith(d);
}

double ShapeOf(const std::vector<Point>& points, const Tetrahedron& cell)
{
  return ShapeOf(points[cell[0]], points[cell[1]], points[cell[2]], points[cell[3]]);
}

double WorstShapeOf(const RefinableMesh& mesh, const std::vector<Id>& cells)
{
  double worst = 1;
  for (const Id cell : cells)
  {
    worst = std::min(worst, ShapeOf(mesh.Points, mesh.Cell(cell).Corners));
  }
  return worst;
}

double ShapeOfAngle(double degrees)
{
  const double sine = std::sin(degrees * std::acos(-1.0) / 180);
  return sine * sine;
}

Point Barycentre(const std::vector<Point>& points, const Tetrahedron& cell)
{
  Point sum = { { 0, 0, 0 } };
  for (const Id corner : cell)
  {
    for (int k = 0; k < 3; ++k)
    {
      sum[k] += points[corner][k] / 4;
    }
  }
  return sum;
}

Circumsphere CircumsphereOf(const Point& a, const Point& b, const Point& c, const Point& d)
{
  const Point u = Difference(b, a);
  const Point v = Difference(c, a);
  const Point w = Difference(d, a);
  const Point vw = Cross(v, w);
  const Point wu = Cross(w, u);
  const Point uv = Cross(u, v);
  const double scale = 0.5 / Dot(u, vw);
  const double uu = Dot(u, u);
  const double vv = Dot(v, v);
  const double ww = Dot(w, w);
  Point offset;
  for (int k = 0; k < 3; ++k)
  {
    offset[k] = scale * (uu * vw[k] + vv * wu[k] + ww * uv[k]);
  }
  return { { { a[0] + offset[0], a[1] + offset[1], a[2] + offset[2] } }, Dot(offset, offset) };
}

Circumsphere CircumcircleOf(const std::array<Point, 3>& triangle)
{
  const Point u = Difference(triangle[1], triangle[0]);
  const Point v = Difference(triangle[2], triangle[0]);
  const Point normal = Cross(u, v);
  const Point toV = Cross(normal, u);
  const Point toU = Cross(v, normal);
  const double scale = 0.5 / Dot(normal, normal);
  const double uu = Dot(u, u);
  const double vv = Dot(v, v);
  Point offset;
  for (int k = 0; k < 3; ++k)
  {
    offset[k] = scale * (uu * toU[k] + vv * toV[k]);
  }
  const Point& a = triangle[0];
  return { { { a[0] + offset[0], a[1] + offset[1], a[2] + offset[2] } }, Dot(offset, offset) };
}
} // namespace insideout
