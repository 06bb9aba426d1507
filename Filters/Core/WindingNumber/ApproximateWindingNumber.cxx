// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/ApproximateWindingNumber.h"

#include "Common/Error.h"
#include "Common/ParallelLoop.h"
#include "Common/Vectors.h"
#include "WindingNumber/SolidAngle.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
namespace
{
constexpr Id LeafSize = 4;

/** Area times unit normal. */
Point VectorArea(const std::array<Point, 3>& p)
{
  const Point normal = NormalOf(p[0], p[1], p[2]);
  return { normal[0] / 2, normal[1] / 2, normal[2] / 2 };
}
} // namespace

ApproximateWindingNumber::ApproximateWindingNumber(const std::vector<Point>& points,
  const std::vector<CountedTriangle>& triangles, int order, double accuracy)
  : Points(points)
  , Order(order)
  , Accuracy(accuracy)
  , Tree(points, triangles, LeafSize)
{
  if (order < 1 || order > 3)
  {
    throw Error(ErrorCode::InvalidParameter,
      "the order of the approximation is " + std::to_string(order) + "; it has to be 1, 2 or 3");
  }
  if (!(accuracy >= 1))
  {
    throw Error(ErrorCode::InvalidParameter, "the accuracy of the approximation is below 1");
  }
  this->Expansions.resize(this->Tree.Nodes.size());
  // Each level of the tree contains each triangle once.
  const double size = static_cast<double>(this->Expansions.size());
  const double nanosecondsPerTriangle = 20;
  const double nanosecondsPerNode = nanosecondsPerTriangle * LeafSize * std::log2(size + 1);
  ParallelLoop(this->Expansions.size(), nanosecondsPerNode,
    [&](std::size_t i) { this->Expansions[i] = this->Expand(this->Tree.Nodes[i]); });
}

ApproximateWindingNumber::Expansion ApproximateWindingNumber::Expand(
  const FacetTree::Node& node) const
{
  FarField field;
  double area = 0;
  for (Id i = node.Begin; i < node.End; ++i)
  {
    const std::array<Point, 3> p = CornersOf(this->Points, this->Tree.Triangles[i].Corners);
    const double weight = Length(VectorArea(p));
    area += weight;
    for (int axis = 0; axis < 3; ++axis)
    {
      field.Centre[axis] += weight * (p[0][axis] + p[1][axis] + p[2][axis]) / 3;
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    field.Centre[axis] =
      area > 0 ? field.Centre[axis] / area : node.Bounds.Low[axis] / 2 + node.Bounds.High[axis] / 2;
  }
  double squaredRadius = 0;
  for (Id i = node.Begin; i < node.End; ++i)
  {
    const CountedTriangle& triangle = this->Tree.Triangles[i];
    std::array<Point, 3> d = CornersOf(this->Points, triangle.Corners);
    Point n = VectorArea(d);
    Point sum = { 0, 0, 0 };
    for (Point& corner : d)
    {
      corner = Difference(corner, field.Centre);
      squaredRadius = std::max(squaredRadius, Dot(corner, corner));
      for (int axis = 0; axis < 3; ++axis)
      {
        sum[axis] += corner[axis];
      }
    }
    std::array<double, 6> products;
    for (int jk = 0; jk < 6; ++jk)
    {
      const auto& [j, k] = FarField::SecondAxes[jk];
      products[jk] =
        (sum[j] * sum[k] + d[0][j] * d[0][k] + d[1][j] * d[1][k] + d[2][j] * d[2][k]) / 12;
    }
    for (double& x : n)
    {
      x *= triangle.Count;
    }
    field.Add(n, { sum[0] / 3, sum[1] / 3, sum[2] / 3 }, products);
  }
  return { field, squaredRadius * this->Accuracy * this->Accuracy };
}

double ApproximateWindingNumber::At(const Point& p) const
{
  double w = 0;
  std::size_t index = 0;
  std::array<Id, 64> stack; // enough, because the tree is balanced
  int depth = 0;
  if (!this->Tree.Nodes.empty())
  {
    stack[depth++] = 0;
  }
  while (depth > 0)
  {
    index = static_cast<std::size_t>(stack[--depth]);
    const FacetTree::Node& node = this->Tree.Nodes[index];
    const Expansion& expansion = this->Expansions[index];
    const Point r = Difference(expansion.Field.Centre, p);
    if (Dot(r, r) > expansion.SquaredReach)
    {
      w += expansion.Field.At(r, this->Order);
    }
    else if (node.IsLeaf())
    {
      for (Id i = node.Begin; i < node.End; ++i)
      {
        const CountedTriangle& triangle = this->Tree.Triangles[i];
        w += triangle.Count * WindingNumberOfTriangle(CornersOf(this->Points, triangle.Corners), p);
      }
    }
    else
    {
      stack[depth++] = node.Right;
      stack[depth++] = static_cast<Id>(index) + 1;
    }
  }
  return w;
}
} // namespace insideout
