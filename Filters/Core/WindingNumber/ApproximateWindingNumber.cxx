// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/ApproximateWindingNumber.h"

#include "Common/Error.h"
#include "Common/ParallelLoop.h"
#include "Common/Vectors.h"
#include "WindingNumber/Pi.h"
#include "WindingNumber/SolidAngle.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
namespace
{
constexpr Id LeafSize = 4;

// Pairs of axes as Expansion::Third has them.
constexpr std::array<std::array<int, 2>, 6> AxisPairs = { { { { 0, 0 } }, { { 1, 1 } },
  { { 2, 2 } }, { { 0, 1 } }, { { 1, 2 } }, { { 2, 0 } } } };

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
  // Every level of the tree has each triangle once.
  const double size = static_cast<double>(this->Expansions.size());
  const double nanosecondsPerTriangle = 20;
  const double nanosecondsPerNode = nanosecondsPerTriangle * LeafSize * std::log2(size + 1);
  ParallelLoop(this->Expansions.size(), nanosecondsPerNode,
    [&](std::size_t i) { this->Expansions[i] = this->Expand(this->Tree.Nodes[i]); });
}

ApproximateWindingNumber::Expansion ApproximateWindingNumber::Expand(
  const FacetTree::Node& node) const
{
  Expansion expansion = {};
  double area = 0;
  for (Id i = node.Begin; i < node.End; ++i)
  {
    const std::array<Point, 3> p = CornersOf(this->Points, this->Tree.Triangles[i].Corners);
    const Point normal = VectorArea(p);
    const double weight = Length(normal);
    area += weight;
    for (int axis = 0; axis < 3; ++axis)
    {
      expansion.Centre[axis] += weight * (p[0][axis] + p[1][axis] + p[2][axis]) / 3;
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    expansion.Centre[axis] = area > 0 ? expansion.Centre[axis] / area
                                      : node.Bounds.Low[axis] / 2 + node.Bounds.High[axis] / 2;
  }
  double squaredRadius = 0;
  for (Id i = node.Begin; i < node.End; ++i)
  {
    const CountedTriangle& triangle = this->Tree.Triangles[i];
    std::array<Point, 3> d = CornersOf(this->Points, triangle.Corners);
    const Point normal = VectorArea(d);
    Point sum = { 0, 0, 0 };
    for (Point& corner : d)
    {
      double squared = 0;
      for (int axis = 0; axis < 3; ++axis)
      {
        corner[axis] -= expansion.Centre[axis];
        sum[axis] += corner[axis];
        squared += corner[axis] * corner[axis];
      }
      squaredRadius = std::max(squaredRadius, squared);
    }
    for (int i3 = 0; i3 < 3; ++i3)
    {
      const double n = triangle.Count * normal[i3];
      expansion.First[i3] += n;
      for (int j = 0; j < 3; ++j)
      {
        expansion.Second[3 * i3 + j] += n * sum[j] / 3;
      }
      for (int jk = 0; jk < 6; ++jk)
      {
        const auto& [j, k] = AxisPairs[jk];
        double moment = sum[j] * sum[k];
        for (const Point& corner : d)
        {
          moment += corner[j] * corner[k];
        }
        expansion.Third[6 * i3 + jk] += n * moment / 12;
      }
    }
  }
  expansion.SquaredReach = squaredRadius * this->Accuracy * this->Accuracy;
  return expansion;
}

/**
 * w = integral of n . g(x) / (4 pi) with g(x) = (x - p) / |x - p|^3, by the Taylor series of g
 * about the centre, at r from p.
 */
double ApproximateWindingNumber::Evaluate(
  const Expansion& expansion, const Point& r, double squaredDistance) const
{
  const double inverse = 1 / std::sqrt(squaredDistance);
  const double inverse2 = inverse * inverse;
  const double inverse3 = inverse * inverse2;
  const double inverse5 = inverse3 * inverse2;
  const auto& n = expansion.First;
  double sum = Dot(n, r) * inverse3;
  if (this->Order >= 2)
  {
    // d_j g_i = delta_ij / r^3 - 3 r_i r_j / r^5
    const auto& m = expansion.Second;
    const double product = r[0] * (m[0] * r[0] + m[1] * r[1] + m[2] * r[2]) +
      r[1] * (m[3] * r[0] + m[4] * r[1] + m[5] * r[2]) +
      r[2] * (m[6] * r[0] + m[7] * r[1] + m[8] * r[2]);
    sum += (m[0] + m[4] + m[8]) * inverse3 - 3 * product * inverse5;
  }
  if (this->Order >= 3)
  {
    // d_j d_k g_i = -3 (delta_ij r_k + delta_jk r_i + delta_ik r_j) / r^5 + 15 r_i r_j r_k / r^7
    double deltas = 0;
    double product = 0;
    for (int i = 0; i < 3; ++i)
    {
      const double* t = &expansion.Third[6 * i];
      const auto at = [&](int j, int k) {
        return j == k ? t[j] : t[j + k == 1 ? 3 : j + k == 3 ? 4 : 5];
      };
      deltas +=
        r[i] * (t[0] + t[1] + t[2]) + 2 * (at(i, 0) * r[0] + at(i, 1) * r[1] + at(i, 2) * r[2]);
      product += r[i] *
        (t[0] * r[0] * r[0] + t[1] * r[1] * r[1] + t[2] * r[2] * r[2] +
          2 * (t[3] * r[0] * r[1] + t[4] * r[1] * r[2] + t[5] * r[2] * r[0]));
    }
    sum += (-3 * deltas * inverse5 + 15 * product * inverse5 * inverse2) / 2;
  }
  return sum / (4 * Pi);
}

double ApproximateWindingNumber::At(const Point& p) const
{
  double w = 0;
  std::size_t index = 0;
  std::array<Id, 64> stack; // the tree is balanced, so that it is no deeper
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
    const Point r = Difference(expansion.Centre, p);
    const double squared = Dot(r, r);
    if (squared > expansion.SquaredReach)
    {
      w += this->Evaluate(expansion, r, squared);
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
