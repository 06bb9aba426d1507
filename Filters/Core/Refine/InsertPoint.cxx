// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/InsertPoint.h"

#include "Common/PointPredicates.h"
#include "Common/Vectors.h"
#include "Refine/BestPlace.h"
#include "Refine/CellShape.h"

#include <algorithm>
#include <limits>

namespace insideout
{
namespace
{
/** A walk crosses some tens of cells; this limit ends cycles. */
constexpr int MostSteps = 2000;
} // namespace

/** Whether a place is on the inner side of a wall. */
bool PointInsertion::IsSeen(const Triangle& wall, const Point& place) const
{
  const std::vector<Point>& points = this->Mesh.Points;
  return Orient3D(points[wall[0]], points[wall[1]], points[wall[2]], place) > 0;
}

bool PointInsertion::Locate(Id cell, const Point& place)
{
  this->Hole.Place = place;
  Id before = None;
  for (int step = 0; step < MostSteps; ++step)
  {
    const RefinableCell& here = this->Mesh.Cell(cell);
    int across = -1;
    for (int i = 0; i < 4; ++i)
    {
      const int k = (i + step) % 4;
      if (here.Neighbors[k] != None && here.Neighbors[k] == before)
      {
        continue;
      }
      const Triangle f = FaceAcross(here.Corners, k);
      const std::vector<Point>& points = this->Mesh.Points;
      if (Orient3D(points[f[0]], points[f[1]], points[f[2]], this->Hole.Place) < 0)
      {
        across = k;
        break;
      }
    }
    if (across < 0)
    {
      this->Holding = cell;
      return true;
    }
    if (here.Facets[across] != None)
    {
      return false;
    }
    before = cell;
    cell = here.Neighbors[across];
  }
  return false;
}

double PointInsertion::SquaredDistanceToHolder() const
{
  double least = std::numeric_limits<double>::infinity();
  for (const Id corner : this->Mesh.Cell(this->Holding).Corners)
  {
    least = std::min(least, SquaredDistance(this->Mesh.Points[corner], this->Hole.Place));
  }
  return least;
}

/** @param[in] other a cell that has to be replaced, too; or None */
bool PointInsertion::FindCavity(Id other, std::size_t most)
{
  const auto isOpen = [](Id /*cell*/, int /*k*/) { return false; };
  const auto isSeen = [&](const Triangle& wall) { return this->IsSeen(wall, this->Hole.Place); };
  this->Hole.Start(this->Hole.Place);
  this->Hole.Add(this->Holding);
  if (other != None)
  {
    this->Hole.Add(other);
  }
  this->Hole.Grow(most);
  while (this->Hole.CollectWalls(isOpen, isSeen))
  {
    if (!this->Hole.Has(this->Holding))
    {
      return false;
    }
    this->Hole.KeepConnected({ this->Holding }, isOpen);
  }
  return (other == None || this->Hole.Has(other)) && this->Hole.KeepsItsPoints();
}

bool PointInsertion::FindBeside(Id cell, int k, std::size_t most)
{
  const RefinableCell& here = this->Mesh.Cell(cell);
  if (here.Facets[k] != None)
  {
    return false;
  }
  this->Holding = here.Neighbors[k];
  this->Hole.Place = Barycentre(this->Mesh.Points, this->Mesh.Cell(this->Holding).Corners);
  return this->FindCavity(cell, most);
}

double PointInsertion::OptimizePlace()
{
  Point place = this->Hole.Place;
  const double shape = FindBestPlace(this->Mesh.Points, this->Hole.Walls, place);
  if (!std::all_of(this->Hole.Walls.begin(), this->Hole.Walls.end(),
        [&](const Triangle& wall) { return this->IsSeen(wall, place); }))
  {
    return 0;
  }
  this->Hole.Place = place;
  return shape;
}

Id PointInsertion::Insert(double size)
{
  const Id point = this->Mesh.AddPoint(this->Hole.Place, PointKind::Free, size);
  std::vector<Tetrahedron> fresh;
  fresh.reserve(this->Hole.Walls.size());
  for (const Triangle& wall : this->Hole.Walls)
  {
    fresh.push_back({ { wall[0], wall[1], wall[2], point } });
  }
  this->Mesh.Replace(this->Hole.Cells(), fresh);
  return point;
}
} // namespace insideout
