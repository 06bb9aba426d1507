// SPDX-License-Identifier: GPL-3.0-or-later
#include "Defects/NearPoints.h"

#include "Common/Box.h"
#include "Common/ScaledPoints.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace insideout
{
namespace
{
/** Points sorted into the cubes of a grid. */
class Grid
{
public:
  Grid(const std::vector<Point>& points, const Point& origin, double radius)
    : Points(points)
    , Origin(origin)
    , Radius(radius)
  {
    this->Entries.reserve(points.size());
    for (std::size_t p = 0; p < points.size(); ++p)
    {
      this->Entries.emplace_back(this->CubeOf(points[p], 0), static_cast<Id>(p));
    }
    std::sort(this->Entries.begin(), this->Entries.end());
  }

  /** Whether another point is nearer than the radius. */
  bool HasNeighbor(Id p) const
  {
    const Cube low = this->CubeOf(this->Points[p], -this->Radius);
    const Cube high = this->CubeOf(this->Points[p], this->Radius);
    for (std::int64_t i = low[0]; i <= high[0]; ++i)
    {
      for (std::int64_t j = low[1]; j <= high[1]; ++j)
      {
        auto entry = std::lower_bound(
          this->Entries.begin(), this->Entries.end(), Entry({ { i, j, low[2] } }, 0));
        for (; entry != this->Entries.end() && entry->first <= Cube{ { i, j, high[2] } }; ++entry)
        {
          if (entry->second != p &&
            Distance(this->Points[entry->second], this->Points[p]) < this->Radius)
          {
            return true;
          }
        }
      }
    }
    return false;
  }

private:
  using Cube = std::array<std::int64_t, 3>;
  using Entry = std::pair<Cube, Id>;

  /** Cube size: large enough that most points search few cubes, and small enough that most cubes
   * hold few points. */
  static constexpr double CubesPerRadius = 0.25;

  Cube CubeOf(const Point& p, double offset) const
  {
    Cube cube;
    for (int k = 0; k < 3; ++k)
    {
      cube[k] = static_cast<std::int64_t>(
        std::floor((p[k] - this->Origin[k] + offset) / this->Radius * CubesPerRadius));
    }
    return cube;
  }

  const std::vector<Point>& Points;
  const Point Origin;
  const double Radius;
  std::vector<Entry> Entries;
};
} // namespace

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
    const Grid grid(scaled, box.Low, radius);
    for (Id p = 0; p < static_cast<Id>(scaled.size()); ++p)
    {
      near.Count += grid.HasNeighbor(p);
    }
  }
  near.Distance = std::ldexp(radius, exponent);
  return near;
}
} // namespace insideout
