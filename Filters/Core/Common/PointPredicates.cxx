// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/PointPredicates.h"

#include "Common/Kernel.h"
#include "Common/SignOfDeterminant.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
namespace
{
/** The sign of the volume, if certain in doubles. */
inline int OrientInDoubles(const Point& a, const Point& b, const Point& c, const Point& d)
{
  std::array<Point, 3> m;
  for (int k = 0; k < 3; ++k)
  {
    m[k] = { { b[k] - a[k], c[k] - a[k], d[k] - a[k] } };
  }
  const auto largest = [&m](int k) {
    return std::max({ std::abs(m[k][0]), std::abs(m[k][1]), std::abs(m[k][2]) });
  };
  const double x = largest(0);
  const double y = largest(1);
  const double z = largest(2);
  if (x == 0 || y == 0 || z == 0)
  {
    return 0;
  }
  const double determinant = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
    m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
    m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  // Six products, each off by at most eight roundings.
  const double bound = 50 * DoubleEpsilon * x * y * z;
  const bool isInRange =
    std::min({ x, y, z }) > SmallestSize && std::max({ x, y, z }) < LargestSize;
  return !isInRange ? Undecided : determinant > bound ? 1 : determinant < -bound ? -1 : Undecided;
}

/** The same in double-doubles, which represent the differences exactly. */
int OrientInDoubleDoubles(const Point& a, const Point& b, const Point& c, const Point& d)
{
  Rows<DoubleDouble> rows;
  rows.Errors = { { 0, 0, 0 } };
  for (int k = 0; k < 3; ++k)
  {
    rows.Entries[0][k] = TwoSum(b[k], -a[k]);
    rows.Entries[1][k] = TwoSum(c[k], -a[k]);
    rows.Entries[2][k] = TwoSum(d[k], -a[k]);
  }
  return SignOfDeterminant(rows, DoubleDoubleEpsilon);
}

/**
 * Whether the points project to at most two along one of the axes, as in a rectangle of an extruded
 * shape. Then they are coplanar; these are most of the points for which filters fail.
 */
bool AreInPlaneAlongAnAxis(const std::array<const Point*, 4>& points)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const int x = (axis + 1) % 3;
    const int y = (axis + 2) % 3;
    const auto areSame = [x, y](const Point& p, const Point& q)
    { return p[x] == q[x] && p[y] == q[y]; };
    const Point& first = *points[0];
    const Point* second = nullptr;
    bool areTwo = true;
    for (int k = 1; k < 4 && areTwo; ++k)
    {
      const Point& p = *points[k];
      if (!areSame(p, first))
      {
        areTwo = second == nullptr || areSame(p, *second);
        second = &p;
      }
    }
    if (areTwo)
    {
      return true;
    }
  }
  return false;
}
} // namespace

int Orient2D(
  const std::array<double, 2>& a, const std::array<double, 2>& b, const std::array<double, 2>& c)
{
  const auto planar = [](const std::array<double, 2>& p) { return Kernel::Point_2(p[0], p[1]); };
  return CGAL::orientation(planar(a), planar(b), planar(c));
}

int Orient3D(const Point& a, const Point& b, const Point& c, const Point& d)
{
  int sign = OrientInDoubles(a, b, c, d);
  if (sign == Undecided)
  {
    sign = AreInPlaneAlongAnAxis({ { &a, &b, &c, &d } }) ? 0 : OrientInDoubleDoubles(a, b, c, d);
  }
  return sign != Undecided
    ? sign
    : CGAL::orientation(ToFiltered(a), ToFiltered(b), ToFiltered(c), ToFiltered(d));
}

int Orient3D(const std::vector<Point>& points, const Tetrahedron& cell)
{
  return Orient3D(points[cell[0]], points[cell[1]], points[cell[2]], points[cell[3]]);
}

bool IsDegenerate(const Point& a, const Point& b, const Point& c)
{
  return CGAL::collinear(ToFiltered(a), ToFiltered(b), ToFiltered(c));
}

bool IsDegenerate(const std::vector<Point>& points, const Triangle& corners)
{
  return IsDegenerate(points[corners[0]], points[corners[1]], points[corners[2]]);
}
} // namespace insideout
