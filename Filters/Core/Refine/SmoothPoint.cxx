// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/SmoothPoint.h"

#include "Common/PointPredicates.h"
#include "Refine/BestPlace.h"

#include <algorithm>
#include <limits>

namespace insideout
{
namespace
{
constexpr double LeastGain = 1.001;
} // namespace

void PointSmoothing::Collect(Id point)
{
  this->Cells.clear();
  this->Walls.clear();
  this->Mesh.Star(point, this->Cells);
  for (const Id cell : this->Cells)
  {
    this->Walls.push_back(
      FaceAcross(this->Mesh.Cell(cell).Corners, this->Mesh.CornerIndex(cell, point)));
  }
}

bool PointSmoothing::MoveTo(Id point, const Point& place)
{
  const std::vector<Point>& points = this->Mesh.Points;
  for (const Triangle& wall : this->Walls)
  {
    if (Orient3D(points[wall[0]], points[wall[1]], points[wall[2]], place) <= 0)
    {
      return false;
    }
  }
  this->Mesh.Move(point, place, this->Walls);
  return true;
}

bool PointSmoothing::Smooth(Id point)
{
  if (this->Mesh.IsFixed[point] != 0)
  {
    return false;
  }
  this->Collect(point);
  const std::vector<Point>& points = this->Mesh.Points;
  Point place = points[point];
  const double before = std::max(
    0.0, WorstShapeAt(points, this->Walls, place, -std::numeric_limits<double>::infinity()));
  Point mean = { { 0, 0, 0 } };
  for (const Triangle& wall : this->Walls)
  {
    for (const Id corner : wall)
    {
      for (int k = 0; k < 3; ++k)
      {
        mean[k] += points[corner][k] / (3 * static_cast<double>(this->Walls.size()));
      }
    }
  }
  const double wanted = before * LeastGain;
  if (WorstShapeAt(points, this->Walls, mean, wanted) > wanted)
  {
    place = mean;
  }
  return FindBestPlace(points, this->Walls, place) > wanted && this->MoveTo(point, place);
}
} // namespace insideout
