// SPDX-License-Identifier: GPL-3.0-or-later
#include "SteinerPoints.h"

#include <algorithm>

namespace insideout
{
namespace
{
template <typename Container>
void SortUnique(Container& ids)
{
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}
} // namespace

/** Take away edges at a point that carry no constraint. */
void SteinerPoints::LowerDegree(Id point)
{
  const FlipTarget nothing(this->Mesh);
  const FlipOperator::Limits limits = { 0, 10 };
  bool changed = true;
  while (changed)
  {
    changed = false;
    std::vector<Id> star;
    this->Mesh.Star(point, star);
    std::vector<Id> neighbors;
    for (const Id cell : star)
    {
      for (const Id corner : this->Mesh.Cells[cell].Corners)
      {
        if (corner != point && corner != this->Mesh.Infinite())
        {
          neighbors.push_back(corner);
        }
      }
    }
    SortUnique(neighbors);
    for (const Id neighbor : neighbors)
    {
      const Id cell = this->Mesh.FindEdge(point, neighbor);
      changed =
        (cell != None && this->Flips.RemoveEdge(point, neighbor, cell, nothing, limits)) || changed;
    }
  }
}

bool SteinerPoints::RemoveOne(Id point)
{
  if (this->Dissolver.Dissolve(point, VolumePoints::None))
  {
    return true;
  }
  this->LowerDegree(point);
  return this->Dissolver.Dissolve(point, VolumePoints::None);
}

void SteinerPoints::Remove()
{
  bool changed = true;
  while (changed)
  {
    changed = false;
    for (Id point = this->Mesh.Vertices.Size() - 1; point > this->Mesh.Infinite(); --point)
    {
      this->Progress.Check("removing points", 0);
      changed = (this->Mesh.HasVertex(point) && this->RemoveOne(point)) || changed;
    }
  }
}

void SteinerPoints::MoveIntoVolume()
{
  for (Id point = this->Mesh.Vertices.Size() - 1; point > this->Mesh.Infinite(); --point)
  {
    this->Progress.Check("moving points", 0);
    if (this->Mesh.HasVertex(point))
    {
      this->Dissolver.Dissolve(point, VolumePoints::AsNeeded);
    }
  }
}
} // namespace insideout
