// SPDX-License-Identifier: GPL-3.0-or-later
#include "Validate/MergePoints.h"

#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

namespace insideout
{
namespace
{
/** For each point the lowest point with equal coordinates. */
std::vector<Id> MergeEqualPoints(const std::vector<Point>& points)
{
  std::vector<Id> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  // NaN, which only an unused point can hold here, would break the order: those stand aside.
  const auto isNaN = [&](Id p)
  { return std::isnan(points[p][0]) || std::isnan(points[p][1]) || std::isnan(points[p][2]); };
  order.erase(std::remove_if(order.begin(), order.end(), isNaN), order.end());
  std::sort(order.begin(), order.end(),
    [&](Id a, Id b) { return std::tie(points[a], a) < std::tie(points[b], b); });

  std::vector<Id> merged(points.size());
  std::iota(merged.begin(), merged.end(), 0);
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    if (points[order[i]] == points[order[i - 1]])
    {
      merged[order[i]] = merged[order[i - 1]];
    }
  }
  return merged;
}

/** Merge further: each point joins the lowest point not yet joined to another within `tolerance`.
 */
void MergeNearPoints(const std::vector<Point>& points, double tolerance, std::vector<Id>& merged)
{
  using GridCell = std::array<double, 3>;
  const auto gridCell = [&](const Point& x)
  {
    return GridCell{ { std::floor(x[0] / tolerance), std::floor(x[1] / tolerance),
      std::floor(x[2] / tolerance) } };
  };
  std::map<GridCell, std::vector<Id>> kept;
  for (Id p = 0; p < static_cast<Id>(points.size()); ++p)
  {
    if (merged[p] != p)
    {
      merged[p] = merged[merged[p]];
      continue;
    }
    if (!IsFinite(points[p]))
    {
      continue; // no facet uses it
    }
    const GridCell centre = gridCell(points[p]);
    for (int neighbor = 0; neighbor < 27; ++neighbor)
    {
      const auto found = kept.find({ { centre[0] + neighbor % 3 - 1,
        centre[1] + neighbor / 3 % 3 - 1, centre[2] + neighbor / 9 - 1 } });
      if (found == kept.end())
      {
        continue;
      }
      for (const Id q : found->second)
      {
        if (Distance(points[p], points[q]) <= tolerance && q < merged[p])
        {
          merged[p] = q;
        }
      }
    }
    if (merged[p] == p)
    {
      kept[centre].push_back(p);
    }
  }
}
} // namespace

std::vector<Id> MergePoints(const std::vector<Point>& points, double tolerance)
{
  std::vector<Id> merged = MergeEqualPoints(points);
  if (tolerance > 0)
  {
    MergeNearPoints(points, tolerance, merged);
  }
  return merged;
}
} // namespace insideout
