// SPDX-License-Identifier: GPL-3.0-or-later
#include "Output/SeparateOverlaps.h"

#include "Common/Edge.h"
#include "Common/Error.h"
#include "Common/LoopProgress.h"
#include "Output/Regions.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
namespace
{
/** The value of w, rounded, at which two layers overlap. */
constexpr int TwoLayers = 2;

/** A face of an overlap's boundary, where a layer ends. */
struct Wall
{
  Id Cell; ///< of the overlap
  int Face;
};

/** Two walls with an edge in common. */
struct Relation
{
  Id Other;
  bool IsSameLayer;
};

class Separator
{
public:
  Separator(const FacetComplex& surface, const std::vector<double>& w, PartedSolid& solid)
    : Surface(surface)
    , Solid(solid)
    , Mesh(solid.Mesh)
  {
    for (const double value : w)
    {
      // Larger numbers make no difference, and might not fit an int.
      this->Layers.push_back(static_cast<int>(std::lround(std::clamp(value, -9.0, 9.0))));
    }
  }

  OverlapCounts Separate(Monitor& monitor, const ProgressRange& progress);

private:
  bool FindWalls(const std::vector<Id>& cells);
  bool RelateWalls(Id first);
  bool RelateAt(Id wall, const Edge& edge);
  bool ChooseLayers(Id first);
  bool CanBeSeparated(const std::vector<Id>& cells);
  void CopyCells(const std::vector<Id>& cells);
  int LayersIn(Id cell) const { return cell == None ? 0 : this->Layers[cell]; }
  Id WallAt(Id cell, int face) const { return this->WallOfFace[cell][face]; }
  Wall Turn(Wall side, const Edge& edge) const;
  bool Step(Wall& side) const;

  const FacetComplex& Surface;
  PartedSolid& Solid;
  TetrahedralMesh& Mesh;
  std::vector<int> Layers; ///< number of layers in each cell of the hull
  std::vector<Wall> Walls; ///< walls, grouped by overlap
  std::vector<std::array<Id, 4>> WallOfFace;
  std::vector<std::vector<Relation>> Relations; ///< of each wall
  std::vector<signed char> LayerOfWall;         ///< the layer that ends there, 0 or 1
};

bool HasEdge(const Tetrahedron& cell, int face, const Edge& edge)
{
  const Triangle corners = FaceOf(cell, face);
  return std::count_if(corners.begin(), corners.end(),
           [&](Id corner) { return corner == edge[0] || corner == edge[1]; }) == 2;
}

/** The other side of the cell at the edge. */
Wall Separator::Turn(Wall side, const Edge& edge) const
{
  int other = 0;
  while (other == side.Face || !HasEdge(this->Mesh.Cells[side.Cell], other, edge))
  {
    ++other;
  }
  return { side.Cell, other };
}

/** Go through a side, to the same side in the cell beyond. @return false at the mesh's end */
bool Separator::Step(Wall& side) const
{
  const Id next = this->Mesh.Neighbors[side.Cell][side.Face];
  if (next == None)
  {
    return false;
  }
  const auto& back = this->Mesh.Neighbors[next];
  side = { next, static_cast<int>(std::find(back.begin(), back.end(), side.Cell) - back.begin()) };
  return true;
}

/** @return false if a face of the boundary does not define layers */
bool Separator::FindWalls(const std::vector<Id>& cells)
{
  for (const Id cell : cells)
  {
    if (this->Layers[cell] != TwoLayers)
    {
      return false;
    }
    for (int face = 0; face < 4; ++face)
    {
      const Id next = this->Mesh.Neighbors[cell][face];
      if (this->LayersIn(next) >= TwoLayers && this->Solid.Inside[next] == 0)
      {
        return false; // the layers end where no facet is
      }
      const int step = TwoLayers - this->LayersIn(next);
      if (step != 0 && MultiplicityOnEntering(this->Surface, this->Mesh, cell, face) != step)
      {
        return false;
      }
      if (step == 1) // both layers end, so there is no choice
      {
        this->WallOfFace[cell][face] = static_cast<Id>(this->Walls.size());
        this->Walls.push_back({ cell, face });
      }
    }
  }
  return true;
}

/** The next wall around an edge, and whether it bounds the same layer. @return false if the
 * configuration at the edge is not one of the known ones
 */
bool Separator::RelateAt(Id wall, const Edge& edge)
{
  const Wall from = this->Walls[wall];
  Wall inner = this->Turn(from, edge);
  while (this->LayersIn(this->Mesh.Neighbors[inner.Cell][inner.Face]) == TwoLayers)
  {
    this->Step(inner);
    inner = this->Turn(inner, edge);
  }
  const Id other = this->WallAt(inner.Cell, inner.Face);

  std::vector<int> around; // numbers of layers on the way outside, without repetition
  const auto see = [&](int layers)
  {
    if (around.empty() || around.back() != layers)
    {
      around.push_back(layers);
    }
  };
  // Up to the end of the mesh from both sides, if it is reached: outside there are no layers.
  bool isClosed = false;
  Wall outer = from;
  while (!isClosed && this->Step(outer))
  {
    isClosed = outer.Cell == inner.Cell && outer.Face == inner.Face;
    if (!isClosed)
    {
      see(this->Layers[outer.Cell]);
      outer = this->Turn(outer, edge);
    }
  }
  if (!isClosed)
  {
    see(0);
    std::vector<int> back;
    for (outer = inner; this->Step(outer); outer = this->Turn(outer, edge))
    {
      back.push_back(this->Layers[outer.Cell]);
    }
    std::for_each(back.rbegin(), back.rend(), see);
  }
  if (other == None)
  {
    return true; // both layers end there, this one and the other
  }
  const bool isBend = around == std::vector<int>{ 1 };
  if (!isBend && around != std::vector<int>{ 1, 0, 1 })
  {
    return false;
  }
  this->Relations[wall].push_back({ other, isBend });
  this->Relations[other].push_back({ wall, isBend });
  return true;
}

bool Separator::RelateWalls(Id first)
{
  this->Relations.resize(this->Walls.size());
  for (Id wall = first; wall < static_cast<Id>(this->Walls.size()); ++wall)
  {
    const Wall& side = this->Walls[wall];
    const Triangle corners = FaceOf(this->Mesh.Cells[side.Cell], side.Face);
    for (int k = 0; k < 3; ++k)
    {
      if (!this->RelateAt(wall, { corners[k], corners[(k + 1) % 3] }))
      {
        return false;
      }
    }
  }
  return true;
}

/** Assign layers to the walls from the first on. @return false if the relations contradict each
 * other, or leave walls unassigned
 */
bool Separator::ChooseLayers(Id first)
{
  this->LayerOfWall.resize(this->Walls.size(), -1);
  if (first == static_cast<Id>(this->Walls.size()))
  {
    return false;
  }
  std::vector<Id> reached = { first };
  this->LayerOfWall[first] = 0;
  std::size_t chosen = 1;
  while (!reached.empty())
  {
    const Id wall = reached.back();
    reached.pop_back();
    for (const Relation& relation : this->Relations[wall])
    {
      const auto layer = static_cast<signed char>(
        relation.IsSameLayer ? this->LayerOfWall[wall] : 1 - this->LayerOfWall[wall]);
      if (this->LayerOfWall[relation.Other] == -1)
      {
        this->LayerOfWall[relation.Other] = layer;
        reached.push_back(relation.Other);
        ++chosen;
      }
      else if (this->LayerOfWall[relation.Other] != layer)
      {
        return false;
      }
    }
  }
  return chosen == this->Walls.size() - first;
}

bool Separator::CanBeSeparated(const std::vector<Id>& cells)
{
  const Id first = static_cast<Id>(this->Walls.size());
  return this->FindWalls(cells) && this->RelateWalls(first) && this->ChooseLayers(first);
}

/**
 * The cells stay with the layer that ends at walls of layer 0 and continues beyond the others;
 * their copies become the other layer's.
 */
void Separator::CopyCells(const std::vector<Id>& cells)
{
  const Id first = this->Mesh.NumberOfCells();
  const auto copyOf = [&](Id cell)
  {
    return first +
      static_cast<Id>(std::lower_bound(cells.begin(), cells.end(), cell) - cells.begin());
  };
  for (const Id cell : cells)
  {
    this->Mesh.Cells.push_back(Tetrahedron(this->Mesh.Cells[cell]));
    this->Mesh.Facets.push_back(std::array<Id, 4>(this->Mesh.Facets[cell]));
    this->Mesh.FacetSides.push_back(std::array<std::int8_t, 4>(this->Mesh.FacetSides[cell]));
    this->Mesh.Neighbors.push_back({ None, None, None, None });
    this->Solid.Inside.push_back(1);
    this->Solid.Originals.push_back(cell);
  }
  for (const Id cell : cells)
  {
    for (int face = 0; face < 4; ++face)
    {
      Id& next = this->Mesh.Neighbors[cell][face];
      const Id wall = this->WallAt(cell, face);
      Id& nextOfCopy = this->Mesh.Neighbors[copyOf(cell)][face];
      if (this->LayersIn(next) == TwoLayers)
      {
        nextOfCopy = copyOf(next);
      }
      else if (wall != None && this->LayerOfWall[wall] == 0)
      {
        auto& back = this->Mesh.Neighbors[next];
        *std::find(back.begin(), back.end(), cell) = copyOf(cell);
        nextOfCopy = next;
        next = None;
      }
    }
  }
}

OverlapCounts Separator::Separate(Monitor& monitor, const ProgressRange& progress)
{
  std::vector<unsigned char> isOverlap(this->Layers.size());
  for (std::size_t cell = 0; cell < isOverlap.size(); ++cell)
  {
    isOverlap[cell] = this->Layers[cell] >= TwoLayers && this->Solid.Inside[cell] != 0;
  }
  const SolidRegions overlaps = FindRegions(
    this->Mesh, isOverlap, monitor, { progress.Stage, progress.Begin, progress.At(0.3) });
  std::vector<std::vector<Id>> cellsOf(overlaps.Count);
  for (Id cell = 0; cell < static_cast<Id>(isOverlap.size()); ++cell)
  {
    if (isOverlap[cell])
    {
      cellsOf[overlaps.OfCell[cell]].push_back(cell);
    }
  }

  OverlapCounts counts;
  counts.Overlaps = overlaps.Count;
  this->WallOfFace.assign(this->Layers.size(), { None, None, None, None });
  std::vector<Id> separated; // all before any is separated: they are examined in the original hull
  const LoopProgress turns(
    monitor, { progress.Stage, progress.At(0.3), progress.At(0.7) }, cellsOf.size());
  for (Id overlap = 0; overlap < overlaps.Count; ++overlap)
  {
    turns.CheckNow(static_cast<std::size_t>(overlap));
    if (this->CanBeSeparated(cellsOf[overlap]))
    {
      separated.push_back(overlap);
    }
    else if (overlap == static_cast<Id>(separated.size())) // the first that cannot be separated
    {
      counts.Left = this->Mesh.Points[this->Mesh.Cells[cellsOf[overlap].front()][0]];
    }
  }
  std::vector<unsigned char> parted(this->Mesh.Points.size(), 0);
  for (const Id overlap : separated)
  {
    ++counts.Separated;
    counts.CopiedCells += static_cast<Id>(cellsOf[overlap].size());
    this->CopyCells(cellsOf[overlap]);
    for (const Id cell : cellsOf[overlap])
    {
      for (const Id p : this->Mesh.Cells[cell])
      {
        parted[p] = 1;
      }
    }
  }
  PartPoints(this->Solid, parted, monitor, { progress.Stage, progress.At(0.7), progress.End });
  return counts;
}
} // namespace

OverlapCounts SeparateOverlaps(const FacetComplex& surface, const std::vector<double>& w,
  PartedSolid& solid, Monitor& monitor, const ProgressRange& progress)
{
  if (w.size() != solid.Mesh.Cells.size())
  {
    throw Error(ErrorCode::InvalidParameter,
      std::to_string(w.size()) + " winding numbers for " + std::to_string(solid.Mesh.Cells.size()) +
        " cells");
  }
  return Separator(surface, w, solid).Separate(monitor, progress);
}
} // namespace insideout
