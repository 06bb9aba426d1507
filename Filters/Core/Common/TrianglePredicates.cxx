// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/TrianglePredicates.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
namespace
{
/** Whether the line through an edge of `a` has all of `b` on its outer side or on itself. */
bool EdgeSeparates(const ProjectedTriangle& a, const ProjectedTriangle& b)
{
  const CGAL::Orientation inside = CGAL::orientation(a[0], a[1], a[2]);
  for (int k = 0; k < 3; ++k)
  {
    const auto within = [&](const ProjectedPoint& p)
    { return CGAL::orientation(a[k], a[(k + 1) % 3], p) == inside; };
    if (!within(b[0]) && !within(b[1]) && !within(b[2]))
    {
      return true;
    }
  }
  return false;
}
} // namespace

std::array<int, 3> SidesOfPlane(const FilteredTriangle& triangle, const FilteredTriangle& other)
{
  std::array<int, 3> sides;
  for (int k = 0; k < 3; ++k)
  {
    sides[k] = CGAL::orientation(triangle[0], triangle[1], triangle[2], other[k]);
  }
  return sides;
}

ProjectedPoint Project(const FilteredPoint& point, int axis)
{
  return { point[(axis + 1) % 3], point[(axis + 2) % 3] };
}

ProjectedTriangle Project(const FilteredTriangle& triangle, int axis)
{
  return { Project(triangle[0], axis), Project(triangle[1], axis), Project(triangle[2], axis) };
}

int ProjectionAxis(const FilteredTriangle& triangle)
{
  const Kernel::Vector_3 normal =
    CGAL::cross_product(triangle[1] - triangle[0], triangle[2] - triangle[0]);
  std::array<int, 3> axes{ { 0, 1, 2 } };
  std::stable_sort(axes.begin(), axes.end(),
    [&](int a, int b) { return std::abs(normal[a]) > std::abs(normal[b]); });
  for (const int axis : axes)
  {
    const ProjectedTriangle image = Project(triangle, axis);
    if (CGAL::orientation(image[0], image[1], image[2]) != CGAL::COLLINEAR)
    {
      return axis;
    }
  }
  return axes[0];
}

bool OverlapInPlane(const FilteredTriangle& a, const FilteredTriangle& b)
{
  const int axis = ProjectionAxis(a);
  const ProjectedTriangle p = Project(a, axis);
  const ProjectedTriangle q = Project(b, axis);
  return !EdgeSeparates(p, q) && !EdgeSeparates(q, p);
}

bool ContainsInPlane(const FilteredTriangle& triangle, const FilteredPoint& point)
{
  const int axis = ProjectionAxis(triangle);
  const ProjectedTriangle image = Project(triangle, axis);
  const ProjectedPoint p = Project(point, axis);
  const CGAL::Orientation outside = -CGAL::orientation(image[0], image[1], image[2]);
  return CGAL::orientation(image[0], image[1], p) != outside &&
    CGAL::orientation(image[1], image[2], p) != outside &&
    CGAL::orientation(image[2], image[0], p) != outside;
}

bool Pierces(const FilteredPoint& p, const FilteredPoint& q, const FilteredTriangle& triangle)
{
  bool left = false;
  bool right = false;
  for (int k = 0; k < 3; ++k)
  {
    const CGAL::Orientation side = CGAL::orientation(p, q, triangle[k], triangle[(k + 1) % 3]);
    left = left || side == CGAL::POSITIVE;
    right = right || side == CGAL::NEGATIVE;
  }
  return !(left && right);
}
} // namespace insideout
