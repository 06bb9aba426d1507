// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/ContractEdge.h"

#include "Common/PointPredicates.h"
#include "Common/SortUniquely.h"
#include "Common/Vectors.h"
#include "Refine/CellShape.h"

#include <algorithm>

namespace insideout
{
double Contraction::WorstAround(Id point)
{
  this->Cells.clear();
  this->Mesh.Star(point, this->Cells);
  return WorstShapeOf(this->Mesh, this->Cells);
}

bool Contraction::Remove(Id point, double wanted, double longest)
{
  if (this->Mesh.Kinds[point] != PointKind::Free)
  {
    return false;
  }
  this->Mesh.StarWithWalls(point, this->Cells, this->Walls);
  this->Targets.clear();
  for (const Triangle& wall : this->Walls)
  {
    this->Targets.insert(this->Targets.end(), wall.begin(), wall.end());
  }
  SortUniquely(this->Targets);

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
