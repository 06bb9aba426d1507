// SPDX-License-Identifier: GPL-3.0-or-later
#include "Resolve/FindIntersections.h"

#include "Common/BoxTree.h"
#include "Common/ParallelLoop.h"
#include "Common/Stages.h"
#include "Resolve/MeetBeyondSharedCorners.h"

#include <algorithm>

namespace insideout
{
namespace
{
/** Facets, or parts of the tree, that a thread takes at once. */
constexpr Id BlockSize = 256;

Id NumberOfBlocks(Id count)
{
  return (count + BlockSize - 1) / BlockSize;
}

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
  monitor.Check(Stages::FindingIntersections, 0);
  if (firstNew == static_cast<Id>(facets.size()))
  {
    return {};
  }
  const BoxTree tree(BoundingBoxes(points, facets, firstNew));
  std::vector<FilteredPoint> filtered;
  filtered.reserve(points.size());
  for (const Point& p : points)
  {
    filtered.push_back(ToFiltered(p));
  }

  // First among the new facets, then of the others with them.
  const Id blocksOfNew = NumberOfBlocks(tree.NumberOfParts());
  const Id blocks = blocksOfNew + NumberOfBlocks(firstNew);
  std::vector<std::vector<std::array<Id, 2>>> found(blocks);
  const auto search = [&](Id block)
  {
    const auto test = [&](Id i, Id j)
    {
      if (MeetBeyondSharedCorners(filtered, facets[i], facets[j]))
      {
        found[block].push_back({ std::min(i, j), std::max(i, j) });
      }
    };
    if (block < blocksOfNew)
    {
      const Id begin = block * BlockSize;
      for (Id part = begin; part < std::min(begin + BlockSize, tree.NumberOfParts()); ++part)
      {
        tree.VisitPairs(part, [&](Id a, Id b) { test(firstNew + a, firstNew + b); });
      }
      return;
    }
    const Id begin = (block - blocksOfNew) * BlockSize;
    for (Id i = begin; i < std::min(begin + BlockSize, firstNew); ++i)
    {
      tree.Visit(BoundingBox(points, facets[i]), [&](Id leaf) { test(i, firstNew + leaf); });
    }
  };
  const double nanosecondsPerFacet = 1000;
  ParallelLoop(blocks, nanosecondsPerFacet * BlockSize, monitor,
    { Stages::FindingIntersections, 0, 1 }, search);

  std::vector<std::array<Id, 2>> pairs;
  for (const auto& part : found)
  {
    pairs.insert(pairs.end(), part.begin(), part.end());
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}
} // namespace insideout
