// SPDX-License-Identifier: GPL-3.0-or-later
#include "Resolve/Interpolation.h"

#include "Common/TrianglePredicates.h"
#include "Resolve/ConstructedPoint.h"

#include <algorithm>
#include <limits>

namespace insideout
{
namespace
{
/** Twice the signed area, exactly, of three points seen along an axis. */
ExactNumber Area(const Point& a, const Point& b, const Point& c, int axis)
{
  const int x = (axis + 1) % 3;
  const int y = (axis + 2) % 3;
  return (ExactNumber(b[x]) - a[x]) * (ExactNumber(c[y]) - a[y]) -
    (ExactNumber(b[y]) - a[y]) * (ExactNumber(c[x]) - a[x]);
}

/** Exact, for in a sliver doubles would not even give the signs. */
std::array<double, 3> WeightsInPlane(const std::array<Point, 3>& triangle, const Point& p)
{
  const std::vector<FilteredPoint> corners = ToFiltered({ triangle[0], triangle[1], triangle[2] });
  const int axis = ProjectionAxis({ corners[0], corners[1], corners[2] });
  const std::array<Point, 3>& t = triangle;
  const ExactNumber area = Area(t[0], t[1], t[2], axis);
  return { NearestQuotient(Area(p, t[1], t[2], axis), area),
    NearestQuotient(Area(t[0], p, t[2], axis), area),
    NearestQuotient(Area(t[0], t[1], p, axis), area) };
}

/** The weight of `b` in the point of the segment from a to b that is nearest to p. */
double WeightOnEdge(const Point& a, const Point& b, const Point& p)
{
  double along = 0;
  double length = 0;
  for (int k = 0; k < 3; ++k)
  {
    along += (p[k] - a[k]) * (b[k] - a[k]);
    length += (b[k] - a[k]) * (b[k] - a[k]);
  }
  return std::min(1.0, std::max(0.0, along / length));
}

std::array<double, 3> WeightsOnBoundary(const std::array<Point, 3>& triangle, const Point& p)
{
  std::array<double, 3> best{ { 1, 0, 0 } };
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    const double t = WeightOnEdge(triangle[i], triangle[j], p);
    double distance = 0;
    for (int k = 0; k < 3; ++k)
    {
      const double d = triangle[i][k] + t * (triangle[j][k] - triangle[i][k]) - p[k];
      distance += d * d;
    }
    if (distance < nearest)
    {
      nearest = distance;
      best = { { 0, 0, 0 } };
      best[i] = 1 - t;
      best[j] = t;
    }
  }
  return best;
}
} // namespace

std::array<double, 3> BarycentricWeights(const std::array<Point, 3>& triangle, const Point& p)
{
  const std::array<double, 3> weights = WeightsInPlane(triangle, p);
  const bool inside = weights[0] >= 0 && weights[1] >= 0 && weights[2] >= 0;
  return inside ? weights : WeightsOnBoundary(triangle, p);
}
} // namespace insideout
