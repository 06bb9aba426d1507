// SPDX-License-Identifier: GPL-3.0-or-later
#include "TouchedCells.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>

namespace insideout
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/** +1 where d lies on the side that the triangle's normal points to, -1 on the other. */
int Side(const Point& a, const Point& b, const Point& c, const Point& d)
{
  const auto point = [](const Point& x) { return Kernel::Point_3(x[0], x[1], x[2]); };
  return static_cast<int>(CGAL::orientation(point(a), point(b), point(c), point(d)));
}

struct Bounds
{
  Point Low;
  Point High;

  bool IsApart(const Bounds& other) const
  {
    return this->High[0] < other.Low[0] || other.High[0] < this->Low[0] ||
      this->High[1] < other.Low[1] || other.High[1] < this->Low[1] ||
      this->High[2] < other.Low[2] || other.High[2] < this->Low[2];
  }
  void Add(const Point& p)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Low[axis] = std::min(this->Low[axis], p[axis]);
      this->High[axis] = std::max(this->High[axis], p[axis]);
    }
  }
};

template <std::size_t Size>
Bounds BoundsOf(const std::vector<Point>& points, const std::array<Id, Size>& corners)
{
  Bounds bounds = { points[corners[0]], points[corners[0]] };
  for (const Id p : corners)
  {
    bounds.Add(points[p]);
  }
  return bounds;
}

/** Triangles that follow each other, which are mostly close to each other. */
struct Bunch
{
  Bounds All;
  std::vector<Triangle> Triangles;
};

std::vector<Bunch> BunchesOf(
  const std::vector<Point>& points, const std::vector<CountedTriangle>& triangles)
{
  const std::size_t trianglesPerBunch = 16;
  std::vector<Bunch> bunches;
  for (const CountedTriangle& triangle : triangles)
  {
    if (bunches.empty() || bunches.back().Triangles.size() == trianglesPerBunch)
    {
      bunches.push_back({ BoundsOf(points, triangle.Corners), {} });
    }
    bunches.back().Triangles.push_back(triangle.Corners);
    for (const Id p : triangle.Corners)
    {
      bunches.back().All.Add(points[p]);
    }
  }
  return bunches;
}

/** Whether all corners of the cell lie strictly on one side of the triangle's plane. */
bool IsCellBesidePlane(
  const std::vector<Point>& points, const Triangle& triangle, const Tetrahedron& cell)
{
  int least = 1;
  int most = -1;
  for (const Id p : cell)
  {
    const int side = Side(points[triangle[0]], points[triangle[1]], points[triangle[2]], points[p]);
    least = std::min(least, side);
    most = std::max(most, side);
  }
  return least > 0 || most < 0;
}

/** Whether the triangle lies strictly outside a face of the cell. */
bool IsOutsideFace(
  const std::vector<Point>& points, const Triangle& triangle, const Tetrahedron& cell)
{
  for (const std::array<int, 3>& corners : TetrahedronFaces)
  {
    const bool outside = std::all_of(triangle.begin(), triangle.end(),
      [&](Id p)
      {
        return Side(points[cell[corners[0]]], points[cell[corners[1]]], points[cell[corners[2]]],
                 points[p]) > 0;
      });
    if (outside)
    {
      return true;
    }
  }
  return false;
}

bool MayTouch(
  const std::vector<Point>& points, const Triangle& triangle, const Tetrahedron& cell)
{
  return !BoundsOf(points, triangle).IsApart(BoundsOf(points, cell)) &&
    !IsCellBesidePlane(points, triangle, cell) && !IsOutsideFace(points, triangle, cell);
}
} // namespace

std::vector<char> TouchedCells(
  const TetrahedralMesh& mesh, const std::vector<CountedTriangle>& triangles)
{
  const std::vector<Bunch> bunches = BunchesOf(mesh.Points, triangles);
  std::vector<char> touched(mesh.Cells.size(), 0);
#pragma omp parallel for schedule(static)
  for (std::size_t c = 0; c < mesh.Cells.size(); ++c)
  {
    const Tetrahedron& cell = mesh.Cells[c];
    const Bounds bounds = BoundsOf(mesh.Points, cell);
    touched[c] = std::any_of(bunches.begin(), bunches.end(),
      [&](const Bunch& bunch)
      {
        return !bunch.All.IsApart(bounds) &&
          std::any_of(bunch.Triangles.begin(), bunch.Triangles.end(),
            [&](const Triangle& triangle) { return MayTouch(mesh.Points, triangle, cell); });
      });
  }
  return touched;
}
} // namespace insideout
