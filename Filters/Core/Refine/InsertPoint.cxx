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
/** A walk crosses some tens of cells; one that goes round and round ends. */
constexpr int MostSteps = 2000;

double SquaredDistance(const Point& a, const Point& b)
{
  const Point ab = Difference(b, a);
  return Dot(ab, ab);
}
} // namespace

bool PointInsertion::Walk(Id cell)
{
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
      if (Orient3D(points[f[0]], points[f[1]], points[f[2]], this->Place) < 0)
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

/** The nearest first, in steps from cell to cell. */
void PointInsertion::GrowCavity(std::size_t most)
{
  const std::vector<Point>& points = this->Mesh.Points;
  this->Cavity.assign(1, this->Holding);
  this->Mesh.Marks().Start(this->Mesh.NumberOfCells());
  this->Mesh.Marks().Add(this->Holding);
  for (std::size_t next = 0; next < this->Cavity.size() && this->Cavity.size() < most; ++next)
  {
    const RefinableCell& here = this->Mesh.Cell(this->Cavity[next]);
    for (int k = 0; k < 4 && this->Cavity.size() < most; ++k)
    {
      const Id neighbor = here.Neighbors[k];
      if (here.Facets[k] != None || this->Mesh.Marks().Has(neighbor))
      {
        continue;
      }
      const Tetrahedron& c = this->Mesh.Cell(neighbor).Corners;
      const Circumsphere sphere =
        CircumsphereOf(points[c[0]], points[c[1]], points[c[2]], points[c[3]]);
      // Where the cell is too flat for doubles it goes.
      if (!(SquaredDistance(sphere.Center, this->Place) >= sphere.SquaredRadius))
      {
        this->Mesh.Marks().Add(neighbor);
        this->Cavity.push_back(neighbor);
      }
    }
  }
}

/**
 * Collect the walls of the cavity, and take out the cells whose walls the place does not see.
 * @return whether any was taken out; the cell that holds the place is not
 */
bool PointInsertion::CollectWalls(bool& isHopeless)
{
  const std::vector<Point>& points = this->Mesh.Points;
  bool isChanged = false;
  this->Walls.clear();
  for (const Id cell : this->Cavity)
  {
    const RefinableCell& here = this->Mesh.Cell(cell);
    for (int k = 0; k < 4 && this->Mesh.Marks().Has(cell); ++k)
    {
      if (here.Facets[k] == None && this->Mesh.Marks().Has(here.Neighbors[k]))
      {
        continue;
      }
      const Triangle wall = FaceAcross(here.Corners, k);
      if (Orient3D(points[wall[0]], points[wall[1]], points[wall[2]], this->Place) > 0)
      {
        this->Walls.push_back(wall);
      }
      else if (cell == this->Holding)
      {
        isHopeless = true;
        return false;
      }
      else
      {
        this->Mesh.Marks().Remove(cell);
        isChanged = true;
      }
    }
  }
  return isChanged;
}

/** Forget the marked cells that the one that holds the place is no longer connected with. */
void PointInsertion::KeepConnected()
{
  std::vector<Id> reached = { this->Holding };
  this->Mesh.Marks().Remove(this->Holding);
  for (std::size_t next = 0; next < reached.size(); ++next)
  {
    const RefinableCell& here = this->Mesh.Cell(reached[next]);
    for (int k = 0; k < 4; ++k)
    {
      if (here.Facets[k] == None && this->Mesh.Marks().Has(here.Neighbors[k]))
      {
        this->Mesh.Marks().Remove(here.Neighbors[k]);
        reached.push_back(here.Neighbors[k]);
      }
    }
  }
  this->Cavity = std::move(reached);
  this->Mesh.Marks().Start(this->Mesh.NumberOfCells());
  for (const Id cell : this->Cavity)
  {
    this->Mesh.Marks().Add(cell);
  }
}

/** Make the cavity such that the place sees all its walls. */
bool PointInsertion::TrimCavity()
{
  bool isHopeless = false;
  while (this->CollectWalls(isHopeless))
  {
    this->KeepConnected();
  }
  return !isHopeless;
}

/** Whether every corner of the cells is at a wall. */
bool PointInsertion::KeepsItsPoints() const
{
  std::vector<Id> ofWalls;
  for (const Triangle& wall : this->Walls)
  {
    ofWalls.insert(ofWalls.end(), wall.begin(), wall.end());
  }
  std::sort(ofWalls.begin(), ofWalls.end());
  for (const Id cell : this->Cavity)
  {
    for (const Id corner : this->Mesh.Cell(cell).Corners)
    {
      if (!std::binary_search(ofWalls.begin(), ofWalls.end(), corner))
      {
        return false;
      }
    }
  }
  return true;
}

bool PointInsertion::Locate(Id cell, const Point& place)
{
  this->Place = place;
  return this->Walk(cell);
}

double PointInsertion::SquaredDistanceToHolder() const
{
  double least = std::numeric_limits<double>::infinity();
  for (const Id corner : this->Mesh.Cell(this->Holding).Corners)
  {
    least = std::min(least, SquaredDistance(this->Mesh.Points[corner], this->Place));
  }
  return least;
}

bool PointInsertion::FindCavity(std::size_t most)
{
  this->GrowCavity(most);
  return this->TrimCavity() && this->KeepsItsPoints();
}

double PointInsertion::SquaredSpacing() const
{
  double least = std::numeric_limits<double>::infinity();
  for (const Triangle& wall : this->Walls)
  {
    for (const Id corner : wall)
    {
      least = std::min(least, SquaredDistance(this->Mesh.Points[corner], this->Place));
    }
  }
  return least;
}

double PointInsertion::WorstShapeBefore() const
{
  double worst = 1;
  for (const Id cell : this->Cavity)
  {
    worst = std::min(worst, ShapeOf(this->Mesh.Points, this->Mesh.Cell(cell).Corners));
  }
  return worst;
}

double PointInsertion::OptimizePlace()
{
  const std::vector<Point>& points = this->Mesh.Points;
  Point place = this->Place;
  const double shape = FindBestPlace(points, this->Walls, place);
  const bool isSeen = std::all_of(this->Walls.begin(), this->Walls.end(),
    [&](const Triangle& wall)
    { return Orient3D(points[wall[0]], points[wall[1]], points[wall[2]], place) > 0; });
  if (!isSeen)
  {
    return 0;
  }
  this->Place = place;
  return shape;
}

Id PointInsertion::Insert(double size)
{
  const Id point = this->Mesh.AddPoint(this->Place, PointKind::Free, size);
  std::vector<Tetrahedron> fresh;
  fresh.reserve(this->Walls.size());
  for (const Triangle& wall : this->Walls)
  {
    fresh.push_back({ { wall[0], wall[1], wall[2], point } });
  }
  this->Mesh.Replace(this->Cavity, fresh);
  return point;
}
} // namespace insideout
