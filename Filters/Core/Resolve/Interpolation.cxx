// SPDX-License-Identifier: GPL-3.0-or-later
#include "Resolve/Interpolation.h"

#include "Common/TrianglePredicates.h"
#include "Common/Vectors.h"
#include "Resolve/ConstructedPoint.h"

#include <algorithm>
#include <limits>

namespace insideout
{
namespace
{
/** Twice the signed area, exactly, of three points seen along an axis. */
DyadicNumber Area(const Point& a, const Point& b, const Point& c, int axis)
{
  const int x = (axis + 1) % 3;
  const int y = (axis + 2) % 3;
  return (DyadicNumber(b[x]) - a[x]) * (DyadicNumber(c[y]) - a[y]) -
    (DyadicNumber(b[y]) - a[y]) * (DyadicNumber(c[x]) - a[x]);
}

/** Exact, because in a sliver doubles would not even give the signs. */
std::array<double, 3> WeightsInPlane(const std::array<Point, 3>& triangle, const Point& p)
{
  const std::array<Point, 3>& t = triangle;
  const int axis = ProjectionAxis({ ToFiltered(t[0]), ToFiltered(t[1]), ToFiltered(t[2]) });
  const DyadicNumber area = Area(t[0], t[1], t[2], axis);
  return { NearestQuotient(Area(p, t[1], t[2], axis), area),
    NearestQuotient(Area(t[0], p, t[2], axis), area),
    NearestQuotient(Area(t[0], t[1], p, axis), area) };
}

/** The weight of `b` in the point of the segment from a to b that is nearest to p. */
double WeightOnEdge(const Point& a, const Point& b, const Point& p)
{
  const Point edge = Difference(b, a);
  return std::min(1.0, std::max(0.0, Dot(Difference(p, a), edge) / Dot(edge, edge)));
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
