// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/MendFlatCells.h"

#include "Common/ParallelLoop.h"
#include "Common/ScaledPoints.h"
#include "Common/SortedTriangle.h"
#include "Common/Stages.h"
#include "Common/Vectors.h"
#include "Refine/CellShape.h"
#include "Refine/MakeRefinable.h"
#include "Refine/ReconnectCells.h"
#include "Refine/SmoothPoint.h"

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

namespace insideout
{
namespace
{
/** Square of the least sine of a cell that is not flat: volumes of flatter cells have few digits.
 */
constexpr double FlatShape = 1e-20;

/** One change may make room for another. */
constexpr int MostPasses = 4;

/** Cells this number of steps away from flat ones, across points, may change. */
constexpr int MostSteps = 2;

/** Beyond 2 to this power shapes might over- or underflow. */
constexpr int LargestOrdinaryExponent = 60;

/** Per cell, whether isFlat(cell) says so; on several threads. */
template <typename IsFlat>
std::vector<char> FlatCells(std::size_t count, const IsFlat& isFlat)
{
  constexpr double NanosecondsPerCell = 50;
  std::vector<char> flat(count);
  ParallelLoop(
    count, NanosecondsPerCell, [&](std::size_t c) { flat[c] = isFlat(static_cast<Id>(c)); });
  return flat;
}

/** The cells near flat ones as a mesh of their own, without Origins and LostFacets. */
struct NearFlatCells
{
  TetrahedralMesh Mesh;
  std::vector<Id> Cells;                 ///< of the whole mesh, ascending
  std::vector<Id> Points;                ///< the same
  std::vector<std::array<Id, 4>> Beyond; ///< per cell and face, the neighbor in the whole mesh

  /** @param[in] chosen the flat cells */
  NearFlatCells(const TetrahedralMesh& whole, std::vector<char> chosen)
  {
    for (int step = 0; step < MostSteps; ++step)
    {
      ChooseNeighbors(whole, chosen);
    }
    std::vector<Id> numbers(whole.Cells.size(), None);
    for (Id c = 0; c < whole.NumberOfCells(); ++c)
    {
      if (chosen[c] != 0)
      {
        numbers[c] = static_cast<Id>(this->Cells.size());
        this->Cells.push_back(c);
        this->Beyond.push_back(whole.Neighbors[c]);
        this->Mesh.Cells.push_back(whole.Cells[c]);
        this->Mesh.Facets.push_back(whole.Facets[c]);
        this->Mesh.FacetSides.push_back(whole.FacetSides[c]);
      }
    }
    this->Mesh.Neighbors = this->Beyond;
    for (std::array<Id, 4>& neighbors : this->Mesh.Neighbors)
    {
      for (Id& neighbor : neighbors)
      {
        neighbor = neighbor == None ? None : numbers[neighbor];
      }
    }
    this->NumberPoints(whole);
  }

private:
  /** Choose all cells that share a point with a chosen one. */
  static void ChooseNeighbors(const TetrahedralMesh& whole, std::vector<char>& chosen)
  {
    std::vector<char> near(whole.Points.size(), 0);
    for (std::size_t c = 0; c < chosen.size(); ++c)
    {
      for (int i = 0; i < 4 && chosen[c] != 0; ++i)
      {
        near[whole.Cells[c][i]] = 1;
      }
    }
    for (std::size_t c = 0; c < chosen.size(); ++c)
    {
      const Tetrahedron& cell = whole.Cells[c];
      chosen[c] = near[cell[0]] | near[cell[1]] | near[cell[2]] | near[cell[3]];
    }
  }

  void NumberPoints(const TetrahedralMesh& whole)
  {
    std::vector<Id> numbers(whole.Points.size(), None);
    for (const Tetrahedron& cell : this->Mesh.Cells)
    {
      for (const Id corner : cell)
      {
        numbers[corner] = 0;
      }
    }
    for (Id p = 0; p < static_cast<Id>(numbers.size()); ++p)
    {
      if (numbers[p] != None)
      {
        numbers[p] = static_cast<Id>(this->Points.size());
        this->Points.push_back(p);
        this->Mesh.Points.push_back(whole.Points[p]);
      }
    }
    for (Tetrahedron& cell : this->Mesh.Cells)
    {
      for (Id& corner : cell)
      {
        corner = numbers[corner];
      }
    }
  }
};

/** Faces that stay: those on facets, and those of one cell. */
std::vector<FacetOfInput> FixedFaces(const TetrahedralMesh& mesh)
{
  std::vector<FacetOfInput> faces;
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      const Id neighbor = mesh.Neighbors[c][k];
      if (neighbor == None || (mesh.Facets[c][k] != None && c < neighbor))
      {
        Id mirror = None;
        for (int j = 0; j < 4 && neighbor != None; ++j)
        {
          mirror = mesh.Neighbors[neighbor][j] == c ? 4 * neighbor + j : mirror;
        }
        faces.push_back(
          { CornersOf(mesh.Points, FaceOf(mesh.Cells[c], k)), { { 4 * c + k, mirror } }, 0 });
      }
    }
  }
  return faces;
}

class FlatCellMending
{
public:
  /** @param[in] isMovable per point, whether it may move if it lies on no fixed face */
  FlatCellMending(
    RefinableMesh& mesh, const std::vector<FacetOfInput>& fixed, const std::vector<char>& isMovable)
    : Mesh(mesh)
    , IsMovable(isMovable)
    , Surface(mesh, fixed, this->Locked, SurfaceTreatment::Kept, 0)
    , Bound(mesh, fixed, SurfaceTreatment::Kept, 0)
    , Reconnect(mesh, this->Surface, this->Bound)
    , Smooth(mesh, this->Surface, this->Bound)
  {
  }

  /** @return whether any cell was replaced, or any point moved */
  bool Pass()
  {
    const std::vector<char> flat = FlatCells(static_cast<std::size_t>(this->Mesh.NumberOfCells()),
      [this](Id cell) { return this->IsFlat(cell); });
    const std::int64_t before = this->Mesh.NumberOfChanges();
    bool isChanged = false;
    for (Id cell = 0; cell < static_cast<Id>(flat.size()); ++cell)
    {
      if (flat[cell] != 0 && this->IsFlat(cell) && this->HasChanged(cell))
      {
        isChanged |= this->Reconnect.ImproveCell(cell) || this->MoveCorner(cell);
      }
    }
    this->Tried = before;
    return isChanged;
  }

private:
  bool IsFlat(Id cell) const
  {
    return !this->Mesh.IsDead(cell) &&
      ShapeOf(this->Mesh.Points, this->Mesh.Cell(cell).Corners) < FlatShape;
  }

  /** Whether anything around a cell has changed since the pass before began. */
  bool HasChanged(Id cell) const
  {
    const Tetrahedron& corners = this->Mesh.Cell(cell).Corners;
    return std::any_of(corners.begin(), corners.end(),
      [this](Id corner) { return this->Mesh.LastChangeAround(corner) > this->Tried; });
  }

  bool MoveCorner(Id cell)
  {
    const Tetrahedron corners = this->Mesh.Cell(cell).Corners;
    return std::any_of(corners.begin(), corners.end(),
      [this](Id corner)
      {
        return this->IsMovable[corner] != 0 && this->Mesh.Kinds[corner] == PointKind::Free &&
          this->Smooth.Smooth(corner);
      });
  }

  RefinableMesh& Mesh;
  const std::vector<char>& IsMovable;
  const std::vector<char> Locked;
  RefinableSurface Surface;
  SurfaceBound Bound;
  Reconnection Reconnect;
  PointSmoothing Smooth;
  std::int64_t Tried = -1; ///< the number of changes when the pass before began
};

void ResizeCells(TetrahedralMesh& mesh, std::size_t count)
{
  mesh.Cells.resize(count);
  mesh.Neighbors.resize(count);
  mesh.Facets.resize(count);
  mesh.FacetSides.resize(count);
}

/** Leave out cells that no cell has for a neighbor. @param[in] gone ascending */
void RemoveCells(TetrahedralMesh& mesh, const std::vector<Id>& gone)
{
  if (gone.empty())
  {
    return;
  }
  std::vector<Id> numbers(mesh.Cells.size(), None);
  Id count = 0;
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    if (!std::binary_search(gone.begin(), gone.end(), c))
    {
      numbers[c] = count;
      mesh.Cells[count] = mesh.Cells[c];
      mesh.Neighbors[count] = mesh.Neighbors[c];
      mesh.Facets[count] = mesh.Facets[c];
      mesh.FacetSides[count] = mesh.FacetSides[c];
      ++count;
    }
  }
  ResizeCells(mesh, count);
  for (std::array<Id, 4>& neighbors : mesh.Neighbors)
  {
    for (Id& neighbor : neighbors)
    {
      neighbor = neighbor == None ? None : numbers[neighbor];
    }
  }
}

/** A fixed face, 4 * cell + face of the mesh before, on the side from which `corners` are seen. */
Id FaceBefore(const TetrahedralMesh& before, const FacetOfInput& fixed, const Triangle& corners)
{
  const auto [one, other] = fixed.Faces;
  const Triangle face = FaceOf(before.Cells[one / 4], one % 4);
  return SortedTriangle(face).Turned == SortedTriangle(corners).Turned ? one : other;
}

/** Make a cell the neighbor of another across a face of both. */
void SetNeighbor(TetrahedralMesh& mesh, Id other, const Triangle& face, Id cell)
{
  for (int k = 0; k < 4; ++k)
  {
    const Triangle mirror = FaceOf(mesh.Cells[other], k);
    if (SortedTriangle(mirror).Points == SortedTriangle(face).Points)
    {
      mesh.Neighbors[other][k] = cell;
    }
  }
}

/** Put mended cells in place of those that were near flat ones. */
void PutBack(const NearFlatCells& near, const RefinableMesh& mended,
  const std::vector<FacetOfInput>& fixed, TetrahedralMesh& whole)
{
  for (std::size_t p = 0; p < near.Points.size(); ++p)
  {
    whole.Points[near.Points[p]] = mended.Points[p];
  }
  // Cells take the numbers of those before, in order; further ones are appended.
  std::vector<Id> free = near.Cells;
  for (Id c = whole.NumberOfCells(); free.size() < static_cast<std::size_t>(mended.NumberOfCells());
       ++c)
  {
    free.push_back(c);
  }
  std::vector<Id> numbers(mended.NumberOfCells(), None);
  auto next = free.begin();
  for (Id c = 0; c < mended.NumberOfCells(); ++c)
  {
    numbers[c] = mended.IsDead(c) ? None : *next++;
  }
  ResizeCells(whole, whole.Cells.size() + free.size() - near.Cells.size());
  for (Id c = 0; c < mended.NumberOfCells(); ++c)
  {
    const RefinableCell& cell = mended.Cell(c);
    const Id number = numbers[c];
    for (int i = 0; i < 4 && number != None; ++i)
    {
      whole.Cells[number][i] = near.Points[cell.Corners[i]];
    }
    for (int k = 0; k < 4 && number != None; ++k)
    {
      const Id inner = cell.Neighbors[CornerAcrossFrom[k]];
      Id neighbor = inner == None ? None : numbers[inner];
      Id facet = None;
      std::int8_t side = 0;
      if (const Id f = cell.Facets[CornerAcrossFrom[k]]; f != None)
      {
        const Id face = FaceBefore(near.Mesh, fixed[f], FaceOf(cell.Corners, k));
        facet = near.Mesh.Facets[face / 4][face % 4];
        side = near.Mesh.FacetSides[face / 4][face % 4];
        if (inner == None && near.Beyond[face / 4][face % 4] != None)
        {
          neighbor = near.Beyond[face / 4][face % 4];
          SetNeighbor(whole, neighbor, FaceOf(whole.Cells[number], k), number);
        }
      }
      whole.Neighbors[number][k] = neighbor;
      whole.Facets[number][k] = facet;
      whole.FacetSides[number][k] = side;
    }
  }
  RemoveCells(whole, { next, free.end() });
}
} // namespace

void MendFlatCells(TetrahedralMesh& mesh, Monitor& monitor)
{
  monitor.Check(Stages::Tetrahedralizing, 0.98);
  std::vector<char> flat = FlatCells(
    mesh.Cells.size(), [&mesh](Id c) { return ShapeOf(mesh.Points, mesh.Cells[c]) < FlatShape; });
  if (std::find(flat.begin(), flat.end(), 1) == flat.end() ||
    std::abs(LargestExponent(mesh.Points)) > LargestOrdinaryExponent)
  {
    return;
  }
  const NearFlatCells near(mesh, std::move(flat));
  const std::vector<FacetOfInput> fixed = FixedFaces(near.Mesh);
  RefinableMesh refinable = MakeRefinable(near.Mesh, {}, fixed);
  std::vector<char> isMovable;
  for (const Id p : near.Points)
  {
    isMovable.push_back(p >= static_cast<Id>(mesh.Points.size()) - mesh.NumberOfSteinerPoints);
  }
  FlatCellMending mending(refinable, fixed, isMovable);
  bool isChanged = false;
  for (int pass = 0; pass < MostPasses && mending.Pass(); ++pass)
  {
    isChanged = true;
    monitor.Check(Stages::Tetrahedralizing, 0.99);
  }
  if (isChanged)
  {
    PutBack(near, refinable, fixed, mesh);
  }
}
} // namespace insideout
