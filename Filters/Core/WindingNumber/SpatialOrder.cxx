// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/SpatialOrder.h"

#include "Common/Box.h"
#include "Common/ParallelLoop.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace insideout
{
namespace
{
constexpr double NanosecondsPerPlace = 7;
constexpr int BitsPerAxis = 10; // of three axes in 32 bits
constexpr std::uint32_t CellsPerAxis = 1u << BitsPerAxis;

/** Spread 10 bits to every third bit. */
std::uint32_t Spread(std::uint32_t x)
{
  x = (x | (x << 16)) & 0x030000ffu;
  x = (x | (x << 8)) & 0x0300f00fu;
  x = (x | (x << 4)) & 0x030c30c3u;
  x = (x | (x << 2)) & 0x09249249u;
  return x;
}

struct Key
{
  std::uint32_t Code;
  Id Index;
};

/** A stable radix sort, 15 bits per pass. */
void SortByCode(std::vector<Key>& keys)
{
  constexpr int digitBits = 3 * BitsPerAxis / 2;
  constexpr std::uint32_t digits = 1u << digitBits;
  std::vector<Key> sorted(keys.size());
  for (int shift : { 0, digitBits })
  {
    std::vector<std::size_t> begin(digits + 1, 0);
    for (const Key& key : keys)
    {
      ++begin[((key.Code >> shift) & (digits - 1)) + 1];
    }
    for (std::uint32_t digit = 0; digit < digits; ++digit)
    {
      begin[digit + 1] += begin[digit];
    }
    for (const Key& key : keys)
    {
      sorted[begin[(key.Code >> shift) & (digits - 1)]++] = key;
    }
    keys.swap(sorted);
  }
}
} // namespace

std::vector<Id> SpatialOrder(const std::vector<Point>& positions)
{
  const Box box = BoundingBox(positions);
  // The same scale on all axes; halves, for the extent itself may overflow.
  double halfExtent = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    halfExtent = std::max(halfExtent, box.High[axis] / 2 - box.Low[axis] / 2);
  }
  const auto digit = [&](double x, double least) -> std::uint32_t
  {
    const double part = halfExtent > 0 ? (x / 2 - least / 2) / halfExtent : 0;
    return std::min(CellsPerAxis - 1, static_cast<std::uint32_t>(part * CellsPerAxis));
  };
  std::vector<Key> keys(positions.size());
  ParallelLoop(positions.size(), NanosecondsPerPlace,
    [&](std::size_t i)
    {
      const Point& p = positions[i];
      keys[i] = { Spread(digit(p[0], box.Low[0])) | Spread(digit(p[1], box.Low[1])) << 1 |
          Spread(digit(p[2], box.Low[2])) << 2,
        static_cast<Id>(i) };
    });
  SortByCode(keys);
  std::vector<Id> order(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    order[i] = keys[i].Index;
  }
  return order;
}

std::vector<Id> SpatialOrderOfAny(std::vector<Point> positions)
{
  for (Point& position : positions)
  {
    position = IsFinite(position) ? position : Point{ 0, 0, 0 };
  }
  return SpatialOrder(positions);
}

std::vector<Id> SpatialOrder(const Sites& sites)
{
  std::vector<Point> positions(sites.Cells.size());
  ParallelLoop(positions.size(), NanosecondsPerPlace,
    [&](std::size_t i)
    {
      const Site site = sites[i];
      for (int axis = 0; axis < 3; ++axis)
      {
        positions[i][axis] = 0;
        for (int k = 0; k < 4; ++k)
        {
          positions[i][axis] += site.Weights[k] * site.Corners[k][axis];
        }
      }
    });
  return SpatialOrder(positions);
}
} // namespace insideout
