// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/PointPredicates.h"

#include "Common/Kernel.h"

namespace insideout
{
int Orient2D(
  const std::array<double, 2>& a, const std::array<double, 2>& b, const std::array<double, 2>& c)
{
  const auto planar = [](const std::array<double, 2>& p) { return Kernel::Point_2(p[0], p[1]); };
  return CGAL::orientation(planar(a), planar(b), planar(c));
}

int Orient3D(const Point& a, const Point& b, const Point& c, const Point& d)
{
  return CGAL::orientation(ToFiltered(a), ToFiltered(b), ToFiltered(c), ToFiltered(d));
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
