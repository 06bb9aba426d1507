// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/TriangleTree.h"

#include "Common/NearestPoint.h"
#include "Common/Vectors.h"
#include "Refine/QuadraticCells.h"

#include <algorithm>
#include <limits>

namespace insideout
{
namespace
{
/** Of a triangle into four, until it is clear how far it is: each halves what is not known. */
constexpr int MostDivisions = 3;

/** Of `enough`: what is known so well need not be known better. */
constexpr double Precision = 0.1;

std::vector<Box> BoxesOf(const std::vector<LabelledTriangle>& triangles)
{
  std::vector<Box> boxes;
  boxes.reserve(triangles.size());
  for (const LabelledTriangle& triangle : triangles)
  {
    boxes.push_back(BoundingBox({ triangle.Corners.begin(), triangle.Corners.end() }));
  }
  return boxes;
}
} // namespace

TriangleTree::TriangleTree(std::vector<LabelledTriangle> triangles)
  : Triangles(std::move(triangles))
  , Tree(BoxesOf(this->Triangles))
{
}

TriangleTree::Nearest TriangleTree::NearestTo(const Point& place, Id label, Id hint) const
{
  Nearest best = { None, place, std::numeric_limits<double>::infinity() };
  const auto look = [&](Id t)
  {
    if (this->Triangles[t].Label == label)
    {
      const Point there = NearestPointOf(this->Triangles[t].Corners, place);
      const double distance = Distance(there, place);
      if (distance < best.Distance)
      {
        best = { t, there, distance };
      }
    }
  };
  if (hint != None)
  {
    look(hint);
  }
  this->Tree.VisitNearestFirst([&](const Box& box) { return SquaredDistance(box, place); },
    [&] { return best.Distance * best.Distance; }, look);
  return best;
}

TriangleTree::Range TriangleTree::RangeOf(
  const LabelledTriangle& triangle, const Limits& limits, Id hint, int divisions) const
{
  const auto& [a, b, c] = triangle.Corners;
  Range range = { 0, std::numeric_limits<double>::infinity() };
  std::array<Id, 3> near;
  for (int k = 0; k < 3; ++k)
  {
    const Nearest nearest = this->NearestTo(triangle.Corners[k], triangle.Label, hint);
    near[k] = hint = nearest.Triangle;
    range.Least = std::max(range.Least, nearest.Distance);
  }
  if (hint == None)
  {
    return range; // there is no triangle of that label
  }
  // The distance from one triangle is convex, so that the corners tell how large it is.
  for (const Id t : near)
  {
    double farthest = 0;
    for (const Point& corner : triangle.Corners)
    {
      farthest =
        std::max(farthest, Distance(NearestPointOf(this->Triangles[t].Corners, corner), corner));
    }
    range.Most = std::min(range.Most, farthest);
  }
  if (range.Most <= limits.Enough || range.Least > limits.TooFar ||
    range.Most - range.Least <= Precision * limits.Enough || divisions == MostDivisions)
  {
    return range;
  }
  const Point ab = Midpoint(a, b);
  const Point bc = Midpoint(b, c);
  const Point ca = Midpoint(c, a);
  range.Most = 0;
  for (const std::array<Point, 3>& part :
    { std::array<Point, 3>{ { bc, ca, ab } }, std::array<Point, 3>{ { a, ab, ca } },
      std::array<Point, 3>{ { ab, b, bc } }, std::array<Point, 3>{ { ca, bc, c } } })
  {
    const Range ofPart = this->RangeOf({ part, triangle.Label }, limits, hint, divisions + 1);
    range.Least = std::max(range.Least, ofPart.Least);
    range.Most = std::max(range.Most, ofPart.Most);
    if (range.Least > limits.TooFar)
    {
      break;
    }
  }
  return range;
}
} // namespace insideout
