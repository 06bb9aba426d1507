// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/TouchedCells.h"

#include "Common/Box.h"
#include "Common/ParallelLoop.h"
#include "Common/Vectors.h"
#include "WindingNumber/SitePredicates.h"
#include "WindingNumber/SpatialOrder.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
namespace
{
struct BoundedTriangle
{
  Box Bounds;
  Point Corner;
  PlaneOfTriangle Plane;

  bool MayTouch(const std::vector<Point>& points, const Tetrahedron& cell, const Box& box) const
  {
    if (!this->Bounds.Meets(box))
    {
      return false;
    }
    int below = 0;
    int above = 0;
    for (const Id p : cell)
    {
      const int side = QuickSide(this->Plane, Difference(this->Corner, points[p]));
      below += side < 0;
      above += side > 0;
    }
    return below < 4 && above < 4;
  }
};

/** Some triangles and a box around them. */
struct Bunch
{
  Box Bounds;
  std::vector<BoundedTriangle> Triangles;
};

/** A box around some bunches. */
struct Group
{
  Box Bounds;
  std::vector<Bunch> Bunches;
};

/** Group triangles that are neighbors in space. */
std::vector<Group> MakeGroups(
  const std::vector<Point>& points, const std::vector<Triangle>& triangles)
{
  const std::size_t trianglesPerBunch = 8;
  const std::size_t bunchesPerGroup = 8;
  std::vector<Point> places;
  for (const Triangle& t : triangles)
  {
    places.push_back(points[t[0]]);
  }
  std::vector<Group> groups;
  for (const Id i : SpatialOrder(places))
  {
    const Triangle& t = triangles[i];
    const Box box = BoundingBox(points, t);
    const bool isFull =
      groups.empty() || groups.back().Bunches.back().Triangles.size() == trianglesPerBunch;
    if (groups.empty() || (isFull && groups.back().Bunches.size() == bunchesPerGroup))
    {
      groups.push_back({ box, {} });
    }
    Group& group = groups.back();
    if (isFull)
    {
      group.Bunches.push_back({ box, {} });
    }
    group.Bounds.Add(box);
    group.Bunches.back().Bounds.Add(box);
    group.Bunches.back().Triangles.push_back(
      { box, points[t[0]], PlaneOfTriangle(CornersOf(points, t)) });
  }
  return groups;
}

bool MayTouch(
  const Group& group, const std::vector<Point>& points, const Tetrahedron& cell, const Box& box)
{
  return group.Bounds.Meets(box) &&
    std::any_of(group.Bunches.begin(), group.Bunches.end(),
      [&](const Bunch& bunch)
      {
        return bunch.Bounds.Meets(box) &&
          std::any_of(bunch.Triangles.begin(), bunch.Triangles.end(),
            [&](const BoundedTriangle& triangle) { return triangle.MayTouch(points, cell, box); });
      });
}
} // namespace

std::vector<char> TouchedCells(const std::vector<Point>& points,
  const std::vector<Tetrahedron>& cells, const std::vector<std::vector<CountedTriangle>>& groups)
{
  std::vector<Triangle> all;
  for (const std::vector<CountedTriangle>& triangles : groups)
  {
    for (const CountedTriangle& triangle : triangles)
    {
      all.push_back(triangle.Corners);
    }
  }
  const std::vector<Group> made = MakeGroups(points, all);
  std::vector<char> touched(cells.size(), 0);
  const double nanosecondsPerCell = 10 + 5 * static_cast<double>(made.size());
  ParallelLoop(cells.size(), nanosecondsPerCell,
    [&](std::size_t c)
    {
      const Box box = BoundingBox(points, cells[c]);
      touched[c] = std::any_of(made.begin(), made.end(),
        [&](const Group& group) { return MayTouch(group, points, cells[c], box); });
    });
  return touched;
}
} // namespace insideout
