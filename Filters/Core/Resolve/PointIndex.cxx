// SPDX-License-Identifier: GPL-3.0-or-later
#include "Resolve/PointIndex.h"

#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace insideout
{
namespace
{
double SquaredDistance(const Point& p, const Point& q)
{
  const Point d = Difference(p, q);
  return Dot(d, d);
}

std::size_t HashOf(const std::array<double, 3>& cell)
{
  std::size_t hash = 0;
  for (const double x : cell)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof(bits));
    hash = (hash ^ bits) * 0x9E3779B97F4A7C15u;
    hash ^= hash >> 29;
  }
  return hash;
}
} // namespace

PointIndex::PointIndex(double radius)
  : Radius(radius)
{
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
  if (this->Entries.size() + 1 >= this->Buckets.size())
  {
    this->Rehash(std::max<std::size_t>(1024, 2 * this->Buckets.size()));
  }
  const Cell cell = this->CellOf(p);
  Id& bucket = this->Buckets[HashOf(cell) & (this->Buckets.size() - 1)];
  this->Entries.push_back({ cell, p, id, bucket });
  bucket = static_cast<Id>(this->Entries.size()) - 1;
}

void PointIndex::Rehash(std::size_t buckets)
{
  this->Buckets.assign(buckets, None);
  for (std::size_t i = 0; i < this->Entries.size(); ++i)
  {
    Id& bucket = this->Buckets[HashOf(this->Entries[i].Place) & (this->Buckets.size() - 1)];
    this->Entries[i].Next = bucket;
    bucket = static_cast<Id>(i);
  }
}

Id PointIndex::Find(const Point& p) const
{
  if (this->Entries.empty())
  {
    return None;
  }
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
        const Cell place = { cell[0] + i, cell[1] + j, cell[2] + k };
        const std::size_t bucket = HashOf(place) & (this->Buckets.size() - 1);
        for (Id entry = this->Buckets[bucket]; entry != None; entry = this->Entries[entry].Next)
        {
          if (this->Entries[entry].Place != place)
          {
            continue;
          }
          const double distance = SquaredDistance(p, this->Entries[entry].Position);
          const Id id = this->Entries[entry].PointId;
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
