// SPDX-License-Identifier: GPL-3.0-or-later
#include "FindIntersections.h"

#include "BoxTree.h"
#include "ParallelLoop.h"
#include "TrianglePredicates.h"

#include <algorithm>

namespace insideout
{
namespace
{
constexpr const char* Stage = "finding self-intersections";

/** Facets that a thread takes at once. */
constexpr Id BlockSize = 256;

std::vector<Box> BoundingBoxes(
  const std::vector<Point>& points, const std::vector<Triangle>& facets)
{
  std::vector<Box> boxes;
  boxes.reserve(facets.size());
  for (const Triangle& facet : facets)
  {
    boxes.push_back(BoundingBox(points, facet));
  }
  return boxes;
}
} // namespace

std::vector<std::array<Id, 2>> FindIntersections(
  const std::vector<Point>& points, const std::vector<Triangle>& facets, Monitor& monitor)
{
  return FindIntersections(points, facets, 0, monitor);
}

std::vector<std::array<Id, 2>> FindIntersections(const std::vector<Point>& points,
  const std::vector<Triangle>& facets, Id firstNew, Monitor& monitor)
{
  monitor.Check(Stage, 0);
  const Id count = static_cast<Id>(facets.size());
  const BoxTree tree(BoundingBoxes(points, facets));
  const std::vector<FilteredPoint> filtered = ToFiltered(points);

  const Id blocks = (count - firstNew + BlockSize - 1) / BlockSize;
  std::vector<std::vector<std::array<Id, 2>>> found(blocks);
  const auto search = [&](Id block)
  {
    const Id begin = firstNew + block * BlockSize;
    for (Id j = begin; j < std::min(begin + BlockSize, count); ++j)
    {
      tree.Visit(tree[j],
        [&](Id i)
        {
          if (i < j && MeetBeyondSharedCorners(filtered, facets[i], facets[j]))
          {
            found[block].push_back({ i, j });
          }
        });
    }
  };
  ParallelLoop(blocks, monitor, { Stage, 0, 1 }, search);

  std::vector<std::array<Id, 2>> pairs;
  for (const auto& part : found)
  {
    pairs.insert(pairs.end(), part.begin(), part.end());
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}
} // namespace insideout
