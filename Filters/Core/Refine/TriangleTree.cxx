// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/TriangleTree.h"

#include "Common/NearestPoint.h"
#include "Common/Vectors.h"
#include "Refine/QuadraticCells.h"
#include "Refine/UncoveredPart.h"

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

double TriangleTree::LargestDistanceOf(
  const LabelledTriangle& triangle, double enough, Id hint, int divisions) const
{
  const auto& [a, b, c] = triangle.Corners;
  double least = 0;
  std::array<Id, 3> near;
  for (int k = 0; k < 3; ++k)
  {
    const Nearest nearest = this->NearestTo(triangle.Corners[k], triangle.Label, hint);
    near[k] = hint = nearest.Triangle;
    least = std::max(least, nearest.Distance);
  }
  if (hint == None || divisions == MostDivisions)
  {
    return least; // there is no triangle of that label
  }
  // The distance from one triangle is convex, so that the corners tell how large it is.
  double most = std::numeric_limits<double>::infinity();
  for (const Id t : near)
  {
    double farthest = 0;
    for (const Point& corner : triangle.Corners)
    {
      farthest =
        std::max(farthest, Distance(NearestPointOf(this->Triangles[t].Corners, corner), corner));
    }
    most = std::min(most, farthest);
  }
  if (most <= enough || most - least <= Precision * enough)
  {
    return least;
  }
  const Point ab = Midpoint(a, b);
  const Point bc = Midpoint(b, c);
  const Point ca = Midpoint(c, a);
  for (const std::array<Point, 3>& part :
    { std::array<Point, 3>{ { bc, ca, ab } }, std::array<Point, 3>{ { a, ab, ca } },
      std::array<Point, 3>{ { ab, b, bc } }, std::array<Point, 3>{ { ca, bc, c } } })
  {
    least = std::max(
      least, this->LargestDistanceOf({ part, triangle.Label }, enough, hint, divisions + 1));
  }
  return least;
}

bool TriangleTree::IsWithin(const LabelledTriangle& triangle, double distance, Id hint) const
{
  UncoveredPart rest(triangle.Corners, distance);
  for (const Point& corner : triangle.Corners)
  {
    const Nearest nearest = this->NearestTo(corner, triangle.Label, hint);
    if (!(nearest.Distance <= distance))
    {
      return false;
    }
    hint = nearest.Triangle;
    rest.Cover(this->Triangles[hint].Corners);
  }
  if (rest.IsEmpty() || rest.IsHopeless())
  {
    return rest.IsEmpty();
  }
  this->Tree.Visit(
    BoundingBox({ triangle.Corners.begin(), triangle.Corners.end() }).Widened(distance),
    [&](Id t)
    {
      if (this->Triangles[t].Label == triangle.Label && !rest.IsEmpty() && !rest.IsHopeless())
      {
        rest.Cover(this->Triangles[t].Corners);
      }
    });
  return rest.IsEmpty();
}
} // namespace insideout
