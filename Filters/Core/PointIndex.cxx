// SPDX-License-Identifier: GPL-3.0-or-later
#include "PointIndex.h"

#include <cmath>
#include <functional>

namespace insideout
{
namespace
{
double SquaredDistance(const Point& p, const Point& q)
{
  const Point d = { p[0] - q[0], p[1] - q[1], p[2] - q[2] };
  return d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
}
} // namespace

PointIndex::PointIndex(double radius)
  : Radius(radius)
{
}

std::size_t PointIndex::Hash::operator()(const Cell& cell) const
{
  std::size_t hash = 0;
  for (const double x : cell)
  {
    hash = (hash ^ std::hash<double>()(x)) * 0x9E3779B97F4A7C15u;
    hash ^= hash >> 29;
  }
  return hash;
}

PointIndex::Cell PointIndex::CellOf(const Point& p) const
{
  Cell cell;
  for (int k = 0; k < 3; ++k)
  {
    cell[k] = (this->Radius > 0 ? std::floor(p[k] / this->Radius) : p[k]) + 0.0; // -0 becomes 0
  }
  return cell;
}

void PointIndex::Add(const Point& p, Id id)
{
  this->Cells.insert({ this->CellOf(p), { p, id } });
}

Id PointIndex::Find(const Point& p) const
{
  const int reach = this->Radius > 0 ? 1 : 0;
  const Cell cell = this->CellOf(p);
  double nearest = this->Radius * this->Radius;
  Id found = None;
  for (int i = -reach; i <= reach; ++i)
  {
    for (int j = -reach; j <= reach; ++j)
    {
      for (int k = -reach; k <= reach; ++k)
      {
        const auto range = this->Cells.equal_range({ cell[0] + i, cell[1] + j, cell[2] + k });
        for (auto entry = range.first; entry != range.second; ++entry)
        {
          const double distance = SquaredDistance(p, entry->second.Position);
          const Id id = entry->second.PointId;
          if (distance < nearest || (distance == nearest && (found == None || id < found)))
          {
            nearest = distance;
            found = id;
          }
        }
      }
    }
  }
  return found;
}
} // namespace insideout
