// SPDX-License-Identifier: GPL-3.0-or-later
#include "SteinerPoints.h"

#include "PointSupport.h"

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

/** The finite vertices that share an edge with a point, input points first. */
std::vector<Id> SteinerPoints::NeighborsOf(Id point) const
{
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
  return neighbors;
}

/** Take away edges at a point that carry no constraint. */
void SteinerPoints::LowerDegree(Id point)
{
  const FlipTarget nothing(this->Mesh);
  const FlipOperator::Limits limits = { 0, 10 };
  bool changed = true;
  while (changed)
  {
    changed = false;
    const std::vector<Id> neighbors = this->NeighborsOf(point);
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
  return this->Dissolver.Dissolve(point, VolumePoints::None) || this->Collapse(point);
}

bool SteinerPoints::Collapse(Id point)
{
  const PointSupport support = FindPointSupport(this->Mesh, this->Segments, point);
  if (support.Segment != None || !support.Facets.empty())
  {
    return false;
  }
  const std::vector<Id> neighbors = this->NeighborsOf(point);
  return std::any_of(neighbors.begin(), neighbors.end(),
    [&](Id neighbor) { return this->Mover.Collapse(point, neighbor); });
}

void SteinerPoints::Remove()
{
  // What failed once is tried again only when something around has changed.
  std::vector<std::int64_t> triedAt(static_cast<std::size_t>(this->Mesh.Vertices.Size()), -1);
  bool changed = true;
  while (changed)
  {
    changed = false;
    for (Id point = this->Mesh.Vertices.Size() - 1; point > this->Mesh.Infinite(); --point)
    {
      this->Progress.Check("removing points", 0);
      if (this->Mesh.HasVertex(point) && this->Mesh.LastChangeAround(point) > triedAt[point])
      {
        changed = this->RemoveOne(point) || changed;
        triedAt[point] = this->Mesh.NumberOfChanges();
      }
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
