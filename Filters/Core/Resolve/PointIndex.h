// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <vector>

namespace insideout
{
/** Finds points by their coordinates: equal ones (-0 equals 0), or the nearest within a radius. */
class PointIndex
{
public:
  /** @param[in] radius 0 for equal coordinates only */
  explicit PointIndex(double radius);

  void Add(const Point& p, Id id);

  /** The nearest point within the radius, the lowest id of several; None for none. */
  Id Find(const Point& p) const;

private:
  /** The corner of a cube of the radius' size, or with radius 0 the point itself. */
  using Cell = std::array<double, 3>;
  struct Entry
  {
    Cell Place;
    Point Position;
    Id PointId;
    Id Next; ///< the entry with the same hash that was added before this one
  };

  Cell CellOf(const Point& p) const;
  void Rehash(std::size_t buckets);

  double Radius;
  std::vector<Entry> Entries;
  std::vector<Id> Buckets; ///< the last entry by hash; a power of two, more than there are entries
};
} // namespace insideout
