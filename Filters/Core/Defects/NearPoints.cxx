// SPDX-License-Identifier: GPL-3.0-or-later
#include "Defects/NearPoints.h"

#include "Common/BoxTree.h"
#include "Common/ScaledPoints.h"
#include "Common/Vectors.h"

#include <cmath>

namespace insideout
{
NearPoints FindNearPoints(const std::vector<Point>& points, double fraction)
{
  NearPoints near;
  if (points.size() < 2)
  {
    return near;
  }
  const int exponent = LargestExponent(points);
  const std::vector<Point> scaled = ScaledPoints(points, -exponent);
  const Box box = BoundingBox(scaled);
  const double radius = fraction * Distance(box.Low, box.High);
  if (radius > 0) // 0 if the difference underflows
  {
    std::vector<Box> boxes;
    boxes.reserve(scaled.size());
    for (const Point& point : scaled)
    {
      boxes.push_back({ point, point });
    }
    const BoxTree tree(boxes);
    for (Id p = 0; p < static_cast<Id>(scaled.size()); ++p)
    {
      const Box around = boxes[p].Widened(radius);
      bool hasNeighbor = false;
      tree.VisitWhere([&](const Box& other) { return !hasNeighbor && other.Meets(around); },
        [&](Id q) { hasNeighbor |= q != p && Distance(scaled[q], scaled[p]) < radius; });
      near.Count += hasNeighbor;
    }
  }
  near.Distance = std::ldexp(radius, exponent);
  return near;
}
} // namespace insideout
