// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/ContractEdge.h"

#include "Common/PointPredicates.h"
#include "Common/Vectors.h"
#include "Refine/CellShape.h"

#include <algorithm>

namespace insideout
{
double Contraction::WorstAround(Id point)
{
  this->Cells.clear();
  this->Mesh.Star(point, this->Cells);
  double worst = 1;
  for (const Id cell : this->Cells)
  {
    worst = std::min(worst, ShapeOf(this->Mesh.Points, this->Mesh.Cell(cell).Corners));
  }
  return worst;
}

bool Contraction::Remove(Id point, double wanted, double longest)
{
  if (this->Mesh.Kinds[point] != PointKind::Free)
  {
    return false;
  }
  this->Cells.clear();
  this->Walls.clear();
  this->Targets.clear();
  this->Mesh.Star(point, this->Cells);
  for (const Id cell : this->Cells)
  {
    this->Walls.push_back(
      FaceAcross(this->Mesh.Cell(cell).Corners, this->Mesh.CornerIndex(cell, point)));
    this->Targets.insert(this->Targets.end(), this->Walls.back().begin(), this->Walls.back().end());
  }
  std::sort(this->Targets.begin(), this->Targets.end());
  this->Targets.erase(std::unique(this->Targets.begin(), this->Targets.end()), this->Targets.end());

  const std::vector<Point>& points = this->Mesh.Points;
  double best = wanted;
  Id chosen = None;
  for (const Id target : this->Targets)
  {
    double worst = 1;
    for (std::size_t i = 0; i < this->Walls.size() && worst > best; ++i)
    {
      const Triangle& wall = this->Walls[i];
      if (std::find(wall.begin(), wall.end(), target) == wall.end())
      {
        worst = std::min(
          worst, ShapeOf(points[wall[0]], points[wall[1]], points[wall[2]], points[target]));
      }
    }
    if (worst <= best)
    {
      continue;
    }
    const bool isLong = std::any_of(this->Targets.begin(), this->Targets.end(),
      [&](Id other)
      {
        return Distance(points[other], points[target]) >
          longest * 0.5 * (this->Mesh.Sizes[other] + this->Mesh.Sizes[target]);
      });
    if (!isLong)
    {
      best = worst;
      chosen = target;
    }
  }
  if (chosen == None)
  {
    return false;
  }
  this->Fresh.clear();
  for (const Triangle& wall : this->Walls)
  {
    if (std::find(wall.begin(), wall.end(), chosen) == wall.end())
    {
      this->Fresh.push_back({ { wall[0], wall[1], wall[2], chosen } });
      if (Orient3D(points, this->Fresh.back()) <= 0)
      {
        return false;
      }
    }
  }
  this->Mesh.Replace(this->Cells, this->Fresh);
  return true;
}
} // namespace insideout
