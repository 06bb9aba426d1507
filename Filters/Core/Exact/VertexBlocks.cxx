// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/VertexBlocks.h"

#include "Common/Box.h"
#include "Common/ParallelLoop.h"

#include <algorithm>
#include <cstddef>

namespace insideout
{
namespace
{
/** Points of the sample per block. */
constexpr std::size_t SamplesPerBlock = 64;

constexpr double NanosecondsPerVertex = 30;

/** A plane across an axis. */
struct Plane
{
  int Axis;
  double At;
};

/** A binary tree: the planes below planes[i] are planes[2 i] and planes[2 i + 1]. */
void HalveSample(Point* first, Point* end, std::size_t i, std::vector<Plane>& planes)
{
  if (i >= planes.size())
  {
    return;
  }
  Box box = Box::Empty();
  std::for_each(first, end, [&box](const Point& point) { box.Add(point); });
  const int axis = box.LongestAxis();
  Point* const middle = first + (end - first) / 2;
  std::nth_element(
    first, middle, end, [axis](const Point& a, const Point& b) { return a[axis] < b[axis]; });
  planes[i] = { axis, (*middle)[axis] };
  HalveSample(first, middle, 2 * i, planes);
  HalveSample(middle, end, 2 * i + 1, planes);
}
} // namespace

std::vector<Id> BlocksOfVertices(const FlippableMesh& mesh, int levels)
{
  const ExactVertices& vertices = mesh.Vertices();
  const std::size_t points = static_cast<std::size_t>(mesh.Infinite());
  std::vector<Plane> planes(std::size_t(1) << levels);
  std::vector<Point> sample(SamplesPerBlock * planes.size());
  for (std::size_t k = 0; k < sample.size(); ++k)
  {
    sample[k] = vertices.Nearest(static_cast<Id>(points * k / sample.size()));
  }
  HalveSample(sample.data(), sample.data() + sample.size(), 1, planes);
  std::vector<Id> blocks(static_cast<std::size_t>(vertices.Size()), None);
  ParallelLoop(blocks.size(), NanosecondsPerVertex,
    [&](std::size_t vertex)
    {
      const Point point = vertices.Nearest(static_cast<Id>(vertex));
      std::size_t i = 1;
      while (i < planes.size())
      {
        i = 2 * i + (point[planes[i].Axis] < planes[i].At ? 0 : 1);
      }
      blocks[vertex] = static_cast<Id>(i - planes.size());
    });
  blocks[points] = None;
  return blocks;
}
} // namespace insideout
