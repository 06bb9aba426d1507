// SPDX-License-Identifier: GPL-3.0-or-later
#include "GraphCut/CellParts.h"

#include "Common/Error.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace insideout
{
namespace
{
/** The corners of a part. */
struct CornerRange
{
  const Id* First;
  const Id* Last;
  const Id* begin() const { return this->First; }
  const Id* end() const { return this->Last; }
};

CornerRange CornersOf(const CellParts& parts, const std::vector<Id>& corners, std::size_t part)
{
  return { corners.data() + parts.Offsets[part], corners.data() + parts.Offsets[part + 1] };
}

/** The vector from the first corner to the k-th. */
Eigen::Vector3d Edge(const std::vector<Point>& points, CornerRange corners, std::ptrdiff_t k)
{
  const Point& from = points[corners.First[0]];
  const Point& to = points[corners.First[k]];
  return { to[0] - from[0], to[1] - from[1], to[2] - from[2] };
}

/** Area of a polygon by Newell's sum, or the length of an edge. */
double AreaOf(const std::vector<Point>& points, CornerRange corners)
{
  const std::ptrdiff_t size = corners.Last - corners.First;
  Eigen::Vector3d sum = size == 2 ? Edge(points, corners, 1) : Eigen::Vector3d(0, 0, 0);
  for (std::ptrdiff_t k = 1; k + 1 < size; ++k)
  {
    sum += Edge(points, corners, k).cross(Edge(points, corners, k + 1)) / 2;
  }
  return std::hypot(sum[0], sum[1], sum[2]);
}

double VolumeOf(const std::vector<Point>& points, CornerRange corners)
{
  const Eigen::Vector3d normal = Edge(points, corners, 2).cross(Edge(points, corners, 3));
  return std::abs(Edge(points, corners, 1).dot(normal)) / 6;
}
} // namespace

std::vector<InteriorFace> SharedSides(const std::vector<Point>& points, const CellParts& sides)
{
  std::vector<Id> sorted = sides.Corners;
  for (std::size_t side = 0; side < sides.Cells.size(); ++side)
  {
    std::sort(sorted.begin() + sides.Offsets[side], sorted.begin() + sides.Offsets[side + 1]);
  }
  const auto isLess = [&](std::size_t a, std::size_t b)
  {
    const CornerRange ofA = CornersOf(sides, sorted, a);
    const CornerRange ofB = CornersOf(sides, sorted, b);
    return std::lexicographical_compare(ofA.begin(), ofA.end(), ofB.begin(), ofB.end());
  };
  std::vector<std::size_t> order(sides.Cells.size());
  std::iota(order.begin(), order.end(), 0);
  // stable: equal sides stay in the cells' order
  std::stable_sort(order.begin(), order.end(), isLess);
  const auto areEqual = [&](std::size_t i, std::size_t j)
  { return j < order.size() && !isLess(order[i], order[j]); };

  std::vector<InteriorFace> faces;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    if (!areEqual(i, i + 1))
    {
      continue;
    }
    const Id first = sides.Cells[order[i]];
    const Id second = sides.Cells[order[i + 1]];
    if (areEqual(i, i + 2))
    {
      throw Error(ErrorCode::InvalidParameter,
        "cells " + std::to_string(first) + ", " + std::to_string(second) + " and " +
          std::to_string(sides.Cells[order[i + 2]]) + " share one face: the grid does not conform");
    }
    faces.push_back({ first, second, AreaOf(points, CornersOf(sides, sides.Corners, order[i])) });
  }
  return faces;
}

std::vector<double> CellSizes(
  const std::vector<Point>& points, const CellParts& simplices, Id numberOfCells)
{
  std::vector<double> sizes(numberOfCells, 0.0);
  for (std::size_t part = 0; part < simplices.Cells.size(); ++part)
  {
    const CornerRange corners = CornersOf(simplices, simplices.Corners, part);
    const bool isTetrahedron = corners.Last - corners.First == 4;
    sizes[simplices.Cells[part]] +=
      isTetrahedron ? VolumeOf(points, corners) : AreaOf(points, corners);
  }
  return sizes;
}
} // namespace insideout
