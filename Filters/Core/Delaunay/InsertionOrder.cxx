// SPDX-License-Identifier: GPL-3.0-or-later
#include "Delaunay/InsertionOrder.h"

#include "Common/Box.h"
#include "Common/Buckets.h"
#include "Common/Error.h"
#include "Common/Kernel.h"
#include "Common/PointPredicates.h"

#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/hilbert_sort.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <utility>

namespace insideout
{
namespace
{
constexpr std::size_t LargestFirstRound = 64;
constexpr std::size_t Growth = 8;

/** Points per box, where they are spread evenly; each box is one thread's to sort. */
constexpr std::size_t PointsPerBox = 2048;
constexpr int MostLevels = 5; ///< of halvings along each axis

constexpr double NanosecondsPerPoint = 10;
constexpr double NanosecondsPerSortedPoint = 500;

/** CGAL's way to ask for the place of a point. */
struct PlaceOf
{
  using value_type = FilteredPoint;
  using reference = FilteredPoint;
  using key_type = Id;
  using category = boost::readable_property_map_tag;

  const std::vector<Point>* Points;

  friend FilteredPoint get(const PlaceOf& places, Id point)
  {
    return ToFiltered((*places.Points)[static_cast<std::size_t>(point)]);
  }
};

/** The number of a box along Hilbert's curve through all (Skilling 2004). */
std::size_t PlaceOnCurve(std::array<std::uint32_t, 3> box, int levels)
{
  for (std::uint32_t bit = 1u << levels >> 1; bit > 1; bit >>= 1)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const std::uint32_t swapped = (box[0] ^ box[axis]) & (bit - 1);
      const bool isUpper = box[axis] & bit;
      box[0] ^= isUpper ? bit - 1 : swapped;
      box[axis] ^= isUpper ? 0 : swapped;
    }
  }
  box[1] ^= box[0];
  box[2] ^= box[1];
  std::uint32_t flipped = 0;
  for (std::uint32_t bit = 1u << levels >> 1; bit > 1; bit >>= 1)
  {
    flipped ^= box[2] & bit ? bit - 1 : 0;
  }
  std::size_t place = 0;
  for (int level = levels - 1; level >= 0; --level)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      place = place << 1 | ((box[axis] ^ flipped) >> level & 1);
    }
  }
  return place;
}

/** Sort points along a curve: by boxes, and in each box by CGAL. */
void SortAlongCurve(const std::vector<Point>& points, const Box& box, Id* first, std::size_t count)
{
  int levels = 0;
  while (levels < MostLevels && count >> 3 * levels > PointsPerBox)
  {
    ++levels;
  }
  const double boxes = static_cast<double>(1 << levels);
  const auto boxOf = [&](const Point& point)
  {
    std::array<std::uint32_t, 3> indices;
    for (int axis = 0; axis < 3; ++axis)
    {
      // Halves, for the difference itself may overflow.
      const double share = (point[axis] / 2 - box.Low[axis] / 2) /
        std::max(box.High[axis] / 2 - box.Low[axis] / 2, std::numeric_limits<double>::min());
      indices[axis] = static_cast<std::uint32_t>(std::clamp(share * boxes, 0.0, boxes - 1));
    }
    return PlaceOnCurve(indices, levels);
  };
  Buckets<Id> inBoxes =
    Buckets<Id>::Unordered(std::size_t(1) << 3 * levels, count, NanosecondsPerPoint,
      [&](std::size_t i, const auto& visit) { visit(boxOf(points[first[i]]), first[i]); });
  ParallelLoop(inBoxes.Size(),
    NanosecondsPerSortedPoint * static_cast<double>(count) / static_cast<double>(inBoxes.Size()),
    [&](std::size_t b)
    {
      inBoxes.Sort(b, std::less<>());
      const auto inBox = inBoxes[b];
      Id* const begin = first + (inBox.begin() - inBoxes[0].begin());
      std::copy(inBox.begin(), inBox.end(), begin);
      CGAL::hilbert_sort(begin, begin + inBox.Size(),
        CGAL::Spatial_sort_traits_adapter_3<Kernel, PlaceOf>(PlaceOf{ &points }));
    });
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
