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

/** The bounding boxes of the facets from `begin` on. */
std::vector<Box> BoundingBoxes(
  const std::vector<Point>& points, const std::vector<Triangle>& facets, Id begin)
{
  std::vector<Box> boxes;
  boxes.reserve(facets.size() - begin);
  for (auto facet = facets.begin() + begin; facet != facets.end(); ++facet)
  {
    boxes.push_back(BoundingBox(points, *facet));
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
  const BoxTree tree(BoundingBoxes(points, facets, firstNew));
  const std::vector<FilteredPoint> filtered = ToFiltered(points);

  const Id blocks = (count + BlockSize - 1) / BlockSize;
  std::vector<std::vector<std::array<Id, 2>>> found(blocks);
  const auto search = [&](Id block)
  {
    const Id begin = block * BlockSize;
    for (Id i = begin; i < std::min(begin + BlockSize, count); ++i)
    {
      tree.Visit(BoundingBox(points, facets[i]),
        [&](Id leaf)
        {
          const Id j = firstNew + leaf;
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
