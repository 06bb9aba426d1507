// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/SteinerPoints.h"

#include "Exact/EngineLimits.h"
#include "Exact/Phases.h"
#include "Exact/PointSupport.h"

#include <algorithm>

namespace insideout
{
/** Take away edges at a point that carry no constraint. */
void SteinerPoints::LowerDegree(Id point)
{
  const FlipTarget nothing(this->Mesh);
  std::int64_t before = -1; // an edge that stayed stays where nothing has changed since
  while (this->Mesh.NumberOfChanges() > before)
  {
    const std::int64_t since = before;
    before = this->Mesh.NumberOfChanges();
    for (const Id neighbor : this->Mesh.NeighborsOf({ point }))
    {
      const Id cell =
        this->Mesh.LastChangeAround(neighbor) > since ? this->Mesh.FindEdge(point, neighbor) : None;
      if (cell != None)
      {
        this->Flips.RemoveEdge(point, neighbor, cell, nothing, EngineLimits::AnyFlip);
      }
    }
  }
}

bool SteinerPoints::RemoveOne(Id point)
{
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
  const std::vector<Id> neighbors = this->Mesh.NeighborsOf({ point });
  return std::any_of(neighbors.begin(), neighbors.end(),
    [&](Id neighbor) { return this->Mover.Collapse(point, neighbor); });
}

void SteinerPoints::Remove(Id first, std::int64_t since)
{
  // What failed once is tried again only when something around has changed.
  std::vector<std::int64_t> triedAt(
    static_cast<std::size_t>(this->Mesh.Vertices().Size() - first), since);
  std::size_t tried = 0;
  std::size_t removed = 1;
  for (int pass = 0;
       pass < EngineLimits::RemovingPasses && removed > tried / EngineLimits::LeastYield; ++pass)
  {
    tried = 0;
    removed = 0;
    for (Id point = this->Mesh.Vertices().Size() - 1;
         point >= first && !this->Mesh.Work().IsUsedUp(); --point)
    {
      if (this->Mesh.HasVertex(point) &&
        this->Mesh.LastChangeAround(point) > triedAt[point - first])
      {
        this->Progress.Check(Phases::RemovingPoints, 0);
        ++tried;
        removed += this->RemoveOne(point) ? 1 : 0;
        triedAt[point - first] = this->Mesh.NumberOfChanges();
      }
    }
  }
}

void SteinerPoints::Tidy(Id first, std::int64_t since)
{
  this->MoveIntoVolume(first, since);
  this->Remove(first, since);
}

void SteinerPoints::FlipAround(Id vertex, std::mt19937& random)
{
  const FlipTarget nothing(this->Mesh);
  std::vector<Id> star;
  this->Mesh.Star(vertex, star);
  std::int64_t starAt = this->Mesh.NumberOfChanges();
  const std::size_t tries =
    std::min(EngineLimits::FlipsPerCell * star.size(), std::size_t(EngineLimits::FlipsPerShake));
  for (std::size_t k = 0; k < tries; ++k)
  {
    if (this->Mesh.LastChangeAround(vertex) > starAt)
    {
      star.clear();
      this->Mesh.Star(vertex, star);
      starAt = this->Mesh.NumberOfChanges();
    }
    const Id cell = star[random() % star.size()];
    const int i = static_cast<int>(random() % 4);
    const int j = static_cast<int>(i + 1 + random() % 3) % 4;
    const Id u = this->Mesh.Cell(cell).Corners[i];
    const Id v = this->Mesh.Cell(cell).Corners[j];
    if (random() % 2 == 0 || !this->Flips.RemoveFace(cell, i, nothing, EngineLimits::AnyFlip))
    {
      this->Flips.RemoveEdge(u, v, cell, nothing, EngineLimits::AnyFlip);
    }
  }
}

void SteinerPoints::Shake(const std::vector<Id>& points, std::mt19937& random)
{
  for (const Id point : points)
  {
    this->Progress.Check(Phases::ShakingPoints, 0);
    if (this->Mesh.HasVertex(point))
    {
      this->FlipAround(point, random);
      if (!this->RemoveOne(point))
      {
        this->Dissolver.Dissolve(point, VolumePoints::AsNeeded);
      }
    }
  }
}

void SteinerPoints::MoveIntoVolume(Id first, std::int64_t since)
{
  for (Id point = this->Mesh.Vertices().Size() - 1; point >= first && !this->Mesh.Work().IsUsedUp();
       --point)
  {
    if (this->Mesh.HasVertex(point) && this->Mesh.LastChangeAround(point) > since)
    {
      this->Progress.Check(Phases::MovingPoints, 0);
      this->Dissolver.Dissolve(point, VolumePoints::AsNeeded);
    }
  }
}
} // namespace insideout
