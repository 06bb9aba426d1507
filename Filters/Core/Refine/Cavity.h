// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Mesh/CellSet.h"
#include "Refine/RefinableMesh.h"

#include <algorithm>
#include <vector>

namespace insideout
{
/**
 * The cells that are replaced by those between a place and the walls around them (Bowyer 1981,
 * Watson 1981): cells whose circumsphere contains the place, restricted to those whose walls it
 * sees.
 */
class Cavity
{
public:
  explicit Cavity(const RefinableMesh& mesh)
    : Mesh(mesh)
  {
  }

  /** Start with no cells. */
  void Start(const Point& place);

  /** Add a cell that may be there already. */
  void Add(Id cell) { this->Old.Add(cell); }

  bool Has(Id cell) const { return this->Old.Has(cell); }

  /**
   * Add the cells whose circumsphere contains the place, breadth-first up to facets.
   * @param[in] most limit of cells
   */
  void Grow(std::size_t most);

  /**
   * Collect the walls, and leave out the cells with walls that the place does not see.
   * @param[in] isOpen for (cell, k) of a face with a facet, whether the facet is removed
   * @param[in] isSeen whether a wall is seen
   * @return whether any was left out: then call KeepConnected
   */
  template <class IsOpen, class IsSeen>
  bool CollectWalls(const IsOpen& isOpen, const IsSeen& isSeen);

  /** Keep only cells that are connected with `seeds`. */
  template <class IsOpen>
  void KeepConnected(const std::vector<Id>& seeds, const IsOpen& isOpen);

  /** Whether every corner of the cells is at a wall. */
  bool KeepsItsPoints() const;

  /** The squared distance of the nearest corner. */
  double SquaredSpacing() const;

  const std::vector<Id>& Cells() const { return this->Old.Cells(); }

  std::vector<Triangle> Walls;  ///< counter-clockwise seen from within
  std::vector<Id> CellsOfWalls; ///< on their inner sides
  Point Place;

private:
  const RefinableMesh& Mesh;
  CellSet Old;
  mutable CellMarks OnWalls; ///< of points, scratch
};

double SquaredDistance(const Point& a, const Point& b);

template <class IsOpen, class IsSeen>
bool Cavity::CollectWalls(const IsOpen& isOpen, const IsSeen& isSeen)
{
  bool isChanged = false;
  this->Walls.clear();
  this->CellsOfWalls.clear();
  for (const Id cell : this->Cells())
  {
    const RefinableCell& here = this->Mesh.Cell(cell);
    for (int k = 0; k < 4 && this->Has(cell); ++k)
    {
      if (here.Facets[k] == None ? this->Has(here.Neighbors[k]) : isOpen(cell, k))
      {
        continue;
      }
      const Triangle wall = FaceAcross(here.Corners, k);
      if (isSeen(wall))
      {
        this->Walls.push_back(wall);
        this->CellsOfWalls.push_back(cell);
      }
      else
      {
        this->Old.Unmark(cell);
        isChanged = true;
      }
    }
  }
  return isChanged;
}

template <class IsOpen>
void Cavity::KeepConnected(const std::vector<Id>& seeds, const IsOpen& isOpen)
{
  std::vector<Id> reached;
  const auto reach = [&](Id cell)
  {
    if (cell != None && this->Has(cell))
    {
      this->Old.Unmark(cell);
      reached.push_back(cell);
    }
  };
  std::for_each(seeds.begin(), seeds.end(), reach);
  for (std::size_t next = 0; next < reached.size(); ++next)
  {
    for (int k = 0; k < 4; ++k)
    {
      const RefinableCell& here = this->Mesh.Cell(reached[next]);
      if (here.Facets[k] == None || isOpen(reached[next], k))
      {
        reach(here.Neighbors[k]);
      }
    }
  }
  this->Start(this->Place);
  for (const Id cell : reached)
  {
    this->Add(cell);
  }
}
} // namespace insideout
