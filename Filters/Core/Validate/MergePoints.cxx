// SPDX-License-Identifier: GPL-3.0-or-later
#include "Validate/MergePoints.h"

#include "Common/FirstOfEqual.h"
#include "Common/Vectors.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>

namespace insideout
{
namespace
{
/** A hash that is equal for equal coordinates, including 0 and -0. */
std::size_t HashOf(const Point& point)
{
  std::uint64_t hash = 0;
  for (const double x : point)
  {
    const double value = x + 0.0; // -0 becomes 0
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof(bits));
    hash = (hash ^ bits) * 0x9E3779B97F4A7C15u;
    hash ^= hash >> 32;
  }
  return static_cast<std::size_t>(hash);
}

/** For each point the lowest point with equal coordinates; NaN equals nothing. */
std::vector<Id> MergeEqualPoints(const std::vector<Point>& points)
{
  FirstOfEqual equal(points.size());
  std::vector<Id> merged;
  merged.reserve(points.size());
  for (Id p = 0; p < static_cast<Id>(points.size()); ++p)
  {
    // Points that are not finite and unused by facets could be many and fill the table.
    const bool isFinite = IsFinite(points[p]);
    merged.push_back(isFinite
        ? equal.Find(p, HashOf(points[p]), [&](Id other) { return points[other] == points[p]; })
        : p);
  }
  return merged;
}

/** Merge further: each point joins the lowest unjoined point within `tolerance`. */
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
