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
/** Area times unit normal. */
Point VectorArea(const std::array<Point, 3>& p)
{
  const Point normal = NormalOf(p[0], p[1], p[2]);
  return { normal[0] / 2, normal[1] / 2, normal[2] / 2 };
}
} // namespace

ApproximateWindingNumber::ApproximateWindingNumber(const std::vector<Point>& points,
  std::vector<CountedTriangle> triangles, int order, double accuracy)
  : Points(points)
  , Triangles(std::move(triangles))
  , Order(order)
  , Accuracy(accuracy)
  , Tree(BoxTree::OfPoints(CentresOf(points, this->Triangles)))
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
  this->Expansions.resize(static_cast<std::size_t>(this->Tree.NumberOfParts()));
  // Each level of the tree contains each triangle once, the last up to four in each node.
  const double size = static_cast<double>(this->Expansions.size());
  const double nanosecondsPerTriangle = 20;
  const double nanosecondsPerNode = 4 * nanosecondsPerTriangle * std::log2(size + 1);
  ParallelLoop(this->Expansions.size(), nanosecondsPerNode,
    [&](std::size_t i) { this->Expansions[i] = this->Expand(static_cast<Id>(i)); });
}

ApproximateWindingNumber::Expansion ApproximateWindingNumber::Expand(Id part) const
{
  FarField field;
  double area = 0;
  Point somewhere = {};
  const auto addToMean = [&](Id i)
  {
    const std::array<Point, 3> p = CornersOf(this->Points, this->Triangles[i].Corners);
    const double weight = Length(VectorArea(p));
    area += weight;
    somewhere = p[0];
    for (int axis = 0; axis < 3; ++axis)
    {
      field.Centre[axis] += weight * (p[0][axis] + p[1][axis] + p[2][axis]) / 3;
    }
  };
  this->Tree.VisitPart(part, addToMean);
  for (int axis = 0; axis < 3; ++axis)
  {
    field.Centre[axis] = area > 0 ? field.Centre[axis] / area : somewhere[axis];
  }
  double squaredRadius = 0;
  const auto addToField = [&](Id i)
  {
    const CountedTriangle& triangle = this->Triangles[i];
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
  };
  this->Tree.VisitPart(part, addToField);
  return { field, squaredRadius * this->Accuracy * this->Accuracy };
}

double ApproximateWindingNumber::At(const Point& p) const
{
  double w = 0;
  this->Tree.VisitOpened(
    [&](Id part)
    {
      const auto& [field, squaredReach] = this->Expansions[part];
      const Point r = Difference(field.Centre, p);
      const bool isFar = Dot(r, r) > squaredReach;
      w += isFar ? field.At(r, this->Order) : 0;
      return !isFar;
    },
    [&](Id i)
    {
      const CountedTriangle& triangle = this->Triangles[i];
      w += triangle.Count * WindingNumberOfTriangle(CornersOf(this->Points, triangle.Corners), p);
    });
  return w;
}
} // namespace insideout
