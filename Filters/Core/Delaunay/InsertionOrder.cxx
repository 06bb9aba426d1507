// SPDX-License-Identifier: GPL-3.0-or-later
#include "Delaunay/InsertionOrder.h"

#include "Common/Box.h"
#include "Common/Buckets.h"
#include "Common/Error.h"
#include "Common/PointPredicates.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <tuple>
#include <utility>

namespace insideout
{
namespace
{
constexpr std::size_t LargestFirstRound = 64;
constexpr std::size_t Growth = 8;

constexpr int Levels = 21;         ///< of halvings along each of three axes, in 64 bits
constexpr int LevelsOfBuckets = 3; ///< boxes whose points one thread sorts

constexpr double NanosecondsPerPoint = 150;
constexpr double NanosecondsPerBucket = 20000;

/** The number of a box along Hilbert's curve through all (Skilling 2004). */
std::uint64_t PlaceOnCurve(std::array<std::uint32_t, 3> box)
{
  for (std::uint32_t bit = 1u << (Levels - 1); bit > 1; bit >>= 1)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const std::uint32_t swapped = (box[0] ^ box[axis]) & (bit - 1);
      const bool isUpper = (box[axis] & bit) != 0;
      box[0] ^= isUpper ? bit - 1 : swapped;
      box[axis] ^= isUpper ? 0 : swapped;
    }
  }
  box[1] ^= box[0];
  box[2] ^= box[1];
  std::uint32_t flipped = 0;
  for (std::uint32_t bit = 1u << (Levels - 1); bit > 1; bit >>= 1)
  {
    flipped ^= (box[2] & bit) != 0 ? bit - 1 : 0;
  }
  std::uint64_t place = 0;
  for (int level = Levels - 1; level >= 0; --level)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      place = place << 1 | ((box[axis] ^ flipped) >> level & 1);
    }
  }
  return place;
}

/** Sort points along a curve through a cube around all points. */
void SortAlongCurve(
  const std::vector<Point>& points, const Box& bounds, Id* first, std::size_t count)
{
  struct Key
  {
    std::uint64_t Place;
    Id Point;
  };
  // Halves, for the size itself may overflow.
  double halfSize = std::numeric_limits<double>::min();
  for (int axis = 0; axis < 3; ++axis)
  {
    halfSize = std::max(halfSize, bounds.High[axis] / 2 - bounds.Low[axis] / 2);
  }
  constexpr double boxes = 1 << Levels;
  RawVector<Key> keys(count);
  ParallelLoop(count, NanosecondsPerPoint,
    [&](std::size_t i)
    {
      const Point& point = points[static_cast<std::size_t>(first[i])];
      std::array<std::uint32_t, 3> box;
      for (int axis = 0; axis < 3; ++axis)
      {
        const double share = (point[axis] / 2 - bounds.Low[axis] / 2) / halfSize;
        box[axis] = static_cast<std::uint32_t>(std::clamp(share * boxes, 0.0, boxes - 1));
      }
      keys[i] = { PlaceOnCurve(box), first[i] };
    });
  Buckets<Key> buckets =
    Buckets<Key>::Unordered(std::size_t(1) << 3 * LevelsOfBuckets, count, NanosecondsPerPoint,
      [&](std::size_t i, const auto& visit)
      { visit(keys[i].Place >> 3 * (Levels - LevelsOfBuckets), keys[i]); });
  ParallelLoop(buckets.Size(), NanosecondsPerBucket,
    [&](std::size_t bucket)
    {
      buckets.Sort(bucket,
        [](const Key& a, const Key& b)
        { return std::tie(a.Place, a.Point) < std::tie(b.Place, b.Point); });
    });
  keys = std::move(buckets).TakeAll();
  std::transform(keys.begin(), keys.end(), first, [](const Key& key) { return key.Point; });
}

/** Move four points that span space to the front. @throws Error Planar */
void StartWithTetrahedron(const std::vector<Point>& points, std::vector<Id>& order)
{
  const auto at = [&](std::size_t k) -> const Point& { return points[order[k]]; };
  std::size_t found = 0;
  for (std::size_t i = 0; i < order.size() && found < 4; ++i)
  {
    const bool spansMore = found == 0 || (found == 1 && at(i) != at(0)) ||
      (found == 2 && !IsDegenerate(at(0), at(1), at(i))) ||
      (found == 3 && Orient3D(at(0), at(1), at(2), at(i)) != 0);
    if (spansMore)
    {
      const auto begin = order.begin();
      std::rotate(begin + static_cast<std::ptrdiff_t>(found),
        begin + static_cast<std::ptrdiff_t>(i), begin + static_cast<std::ptrdiff_t>(i) + 1);
      ++found;
    }
  }
  if (found < 4)
  {
    throw Error(ErrorCode::Planar, "the points lie in one plane");
  }
}
} // namespace

InsertionOrder OrderOfInsertion(const std::vector<Point>& points)
{
  InsertionOrder order;
  order.Points.resize(points.size());
  std::iota(order.Points.begin(), order.Points.end(), 0);
  std::mt19937 random;
  for (std::size_t i = points.size(); i > 1; --i)
  {
    std::swap(order.Points[i - 1], order.Points[random() % i]);
  }
  order.Rounds = { points.size() };
  while (order.Rounds.back() > LargestFirstRound)
  {
    order.Rounds.push_back(order.Rounds.back() / Growth);
  }
  std::reverse(order.Rounds.begin(), order.Rounds.end());
  const Box box = BoundingBox(points);
  std::size_t first = 0;
  for (const std::size_t end : order.Rounds)
  {
    SortAlongCurve(points, box, order.Points.data() + first, end - first);
    first = end;
  }
  StartWithTetrahedron(points, order.Points);
  return order;
}
} // namespace insideout
