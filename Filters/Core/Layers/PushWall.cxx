// SPDX-License-Identifier: GPL-3.0-or-later
#include "Layers/PushWall.h"

#include "Common/PointPredicates.h"
#include "Common/Vectors.h"
#include "Layers/LayerColumns.h"
#include "Refine/BestPlace.h"
#include "Refine/CellShape.h"

#include <algorithm>
#include <limits>

namespace insideout
{
namespace
{
/**
 * Degrees. A move may flatten cells down to this angle, and halve the quality of worse ones; cells
 * are improved before the next round.
 */
constexpr double LeastAngle = 14;
constexpr double LeastShare = 0.5;

/** Length of a step relative to the edges, so that the wall stays smooth. */
constexpr double StepOfEdges = 0.5;

/** Limit of halvings of a step that is not possible. */
constexpr int MostHalvings = 4;

/** Cosine of 60 degrees. Steeper triangles behind the layers, up to turned ones, are where a point
 * stays and its neighbors go on. */
constexpr double LeastCosineOfTilt = 0.5;

bool IsTooSteep(const LayerColumn& column)
{
  const Point outer = NormalOf(column.Outer[0], column.Outer[1], column.Outer[2]);
  const Point inner = NormalOf(column.Inner[0], column.Inner[1], column.Inner[2]);
  return Dot(outer, inner) < LeastCosineOfTilt * Length(outer) * Length(inner);
}
} // namespace

PushedWall::PushedWall(RefinableMesh& mesh, const WallPush& push)
  : Mesh(mesh)
  , Push(push)
  , Start(mesh.Points)
  , Gone(mesh.Points.size(), 0)
{
}

Id PushedWall::Advance(double share)
{
  Id moved = 0;
  for (const Id point : this->Push.Wall.Points)
  {
    const double gone = this->Gone[point];
    const double left = this->Push.Heights[point] - gone;
    const double most = std::min(
      this->MostAt(point), gone + std::max(share * left, StepOfEdges * this->Mesh.Sizes[point]));
    if (!(most > gone))
    {
      continue;
    }
    this->Mesh.StarWithWalls(point, this->Cells, this->Walls);
    double step = most - gone;
    for (int halving = 0; halving <= MostHalvings; ++halving, step /= 2)
    {
      if (this->MoveTo(point, halving == 0 ? most : gone + step))
      {
        ++moved;
        break;
      }
    }
  }
  return moved;
}

/** Limit of the height of layers at a point, given the heights at its neighbors. */
double PushedWall::MostAt(Id point) const
{
  double most = this->Push.Heights[point];
  for (const Id neighbor : this->Push.Wall.NeighborsOf[point])
  {
    most = std::min(most,
      this->Gone[neighbor] +
        GradingOfHeights * Distance(this->Start[point], this->Start[neighbor]));
  }
  return most;
}

bool PushedWall::MoveTo(Id point, double height)
{
  const Point& start = this->Start[point];
  const Point& way = this->Push.Directions[point].Inward;
  const double length = height * this->Push.Directions[point].LengthPerHeight();
  const Point place = { { start[0] + length * way[0], start[1] + length * way[1],
    start[2] + length * way[2] } };
  const std::vector<Point>& points = this->Mesh.Points;
  const double any = -std::numeric_limits<double>::infinity();
  const double before = WorstShapeAt(points, this->Walls, points[point], any);
  const double least = std::min(ShapeOfAngle(LeastAngle), LeastShare * std::max(before, 0.0));
  if (!(WorstShapeAt(points, this->Walls, place, least) > least) || !this->IsInside(point, place) ||
    !this->AreGood(point, place))
  {
    return false;
  }
  this->Mesh.Move(point, place, this->Walls);
  this->Gone[point] = height;
  return true;
}

/** Whether a place is within the cells around a point and on their side of the wall. */
bool PushedWall::IsInside(Id point, const Point& place) const
{
  const std::vector<Point>& points = this->Mesh.Points;
  const auto sees = [&](const Triangle& t)
  { return Orient3D(points[t[0]], points[t[1]], points[t[2]], place) > 0; };
  const auto at = this->Push.Wall.FacetsAt[point];
  return std::all_of(this->Walls.begin(), this->Walls.end(), sees) &&
    std::all_of(at.begin(), at.end(),
      [&](Id t)
      {
        const Triangle& outward = this->Push.Wall.Triangles[t];
        return sees({ { outward[0], outward[2], outward[1] } });
      });
}

/** Whether the layers around a point are positive and even where it is moved. */
bool PushedWall::AreGood(Id point, const Point& place) const
{
  const auto at = this->Push.Wall.FacetsAt[point];
  return std::all_of(at.begin(), at.end(),
    [&](Id t)
    {
      const Triangle& triangle = this->Push.Wall.Triangles[t];
      LayerColumn column = { CornersOf(this->Start, triangle),
        CornersOf(this->Mesh.Points, triangle) };
      for (int k = 0; k < 3; ++k)
      {
        column.Inner[k] = triangle[k] == point ? place : column.Inner[k];
      }
      return !IsTooSteep(column) && IsPositive(column, this->Push.Fractions);
    });
}
} // namespace insideout
