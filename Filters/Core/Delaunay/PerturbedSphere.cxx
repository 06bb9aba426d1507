// SPDX-License-Identifier: GPL-3.0-or-later
#include "Delaunay/PerturbedSphere.h"

#include "Common/Kernel.h"
#include "Common/PointPredicates.h"

#include <algorithm>

namespace insideout
{
bool IsInSphereExactly(
  const Point& a, const Point& b, const Point& c, const Point& d, const Point& e)
{
  const int side = CGAL::side_of_oriented_sphere(
    ToFiltered(a), ToFiltered(b), ToFiltered(c), ToFiltered(d), ToFiltered(e));
  if (side != 0)
  {
    return side > 0;
  }
  // The last point in lexicographic order moves most. It decides, but where the others are in a
  // plane; then the one before it does.
  std::array<const Point*, 5> order{ { &a, &b, &c, &d, &e } };
  std::sort(order.begin(), order.end(), [](const Point* p, const Point* q) { return *p < *q; });
  for (int k = 4; k > 2; --k)
  {
    if (order[k] == &e)
    {
      return false;
    }
    const auto unless = [&](const Point& corner) -> const Point&
    { return order[k] == &corner ? e : corner; };
    const int orientation = Orient3D(unless(a), unless(b), unless(c), unless(d));
    if (orientation != 0)
    {
      return orientation > 0;
    }
  }
  return false;
}
} // namespace insideout
