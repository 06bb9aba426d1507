// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/TriangleTree.h"

#include "Common/NearestPoint.h"
#include "Common/Vectors.h"
#include "Refine/UncoveredPart.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace insideout
{
namespace
{
/**
 * Limit of subdivisions of a triangle into four, until its distance is certain: each halves the
 * uncertainty.
 */
constexpr int MostDivisions = 3;

/** Margin below the known distance: rounding, and thus the order of triangles, decides nothing. */
constexpr double ClearlyLess = 1 - 1e-9;

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
  Nearest best = { None, place, 0 };
  double least = std::numeric_limits<double>::infinity();
  const auto look = [&](Id t)
  {
    if (this->Triangles[t].Label == label)
    {
      const Point there = NearestPointOf(this->Triangles[t].Corners, place);
      const Point apart = Difference(there, place);
      const double squared = Dot(apart, apart);
      if (squared < least)
      {
        least = squared;
        best = { t, there, 0 };
      }
    }
  };
  if (hint != None)
  {
    look(hint);
  }
  this->Tree.VisitNearestFirst(
    [&](const Box& box) { return SquaredDistance(box, place); }, [&] { return least; }, look);
  best.Distance = std::sqrt(least);
  return best;
}

double TriangleTree::LargestDistanceOf(
  const LabelledTriangle& triangle, const Interest& interest, Id hint, int divisions) const
{
  const auto& [a, b, c] = triangle.Corners;
  double least = 0;
  std::array<Nearest, 3> near;
  for (int k = 0; k < 3; ++k)
  {
    near[k] = this->NearestTo(triangle.Corners[k], triangle.Label, hint);
    hint = near[k].Triangle;
    least = std::max(least, near[k].Distance);
  }
  if (hint == None || divisions == MostDivisions ||
    (divisions == 0 && this->IsWithin(triangle, ClearlyLess * interest.Known, near)))
  {
    return least; // or no triangle of that label exists
  }
  // The distance from one triangle is convex, so the corners bound it.
  double most = std::numeric_limits<double>::infinity();
  for (const auto& [t, place, distance] : near)
  {
    double farthest = 0;
    for (const Point& corner : triangle.Corners)
    {
      farthest =
        std::max(farthest, Distance(NearestPointOf(this->Triangles[t].Corners, corner), corner));
    }
    most = std::min(most, farthest);
  }
  if (most <= ClearlyLess * interest.Known || most - least <= interest.Precision)
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
      least, this->LargestDistanceOf({ part, triangle.Label }, interest, hint, divisions + 1));
  }
  return least;
}

bool TriangleTree::IsWithin(
  const LabelledTriangle& triangle, double distance, const std::array<Nearest, 3>& ofCorners) const
{
  if (std::any_of(ofCorners.begin(), ofCorners.end(),
        [&](const Nearest& nearest) { return !(nearest.Distance <= distance); }))
  {
    return false;
  }
  UncoveredPart rest(triangle.Corners, distance);
  for (int k = 0; k < 3; ++k)
  {
    const Id near = ofCorners[k].Triangle;
    const bool isNew =
      (k == 0 || near != ofCorners[k - 1].Triangle) && (k < 2 || near != ofCorners[0].Triangle);
    if (isNew)
    {
      rest.Cover(this->Triangles[near].Corners);
    }
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
