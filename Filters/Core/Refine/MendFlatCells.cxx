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
#include <limits>
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

constexpr double NanosecondsPerNeighbor = 5;
constexpr double NanosecondsPerFace = 50;

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

/** The cells near flat ones, with numbers of their own. */
class NearFlatCells
{
public:
  /** @param[in] chosen the flat cells */
  NearFlatCells(const TetrahedralMesh& whole, std::vector<char> chosen)
    : Whole(whole)
    , NumberOfCell(whole.Cells.size(), None)
    , NumberOfPoint(whole.Points.size(), None)
  {
    for (int step = 0; step < MostSteps; ++step)
    {
      this->ChooseNeighbors(chosen);
    }
    this->Cells = Number(chosen, this->NumberOfCell);
    this->Points = Number(this->PointsOf(chosen), this->NumberOfPoint);
  }

  /** The neighbor across a face of a cell, None if it is not near. */
  Id NeighborOf(Id cell, int k) const
  {
    const Id neighbor = this->Whole.Neighbors[this->Cells[cell]][k];
    return neighbor == None ? None : this->NumberOfCell[neighbor];
  }

  /** Faces that stay: those on facets, and those of one cell. */
  std::vector<FacetOfInput> FixedFaces() const
  {
    std::vector<char> masks(this->Cells.size()); // a bit per face
    ParallelLoop(this->NumberOfCells(), 4 * NanosecondsPerNeighbor,
      [&](Id c)
      {
        for (int k = 0; k < 4; ++k)
        {
          const Id neighbor = this->NeighborOf(c, k);
          const bool isFixed =
            neighbor == None || (c < neighbor && this->Whole.Facets[this->Cells[c]][k] != None);
          masks[c] |= isFixed ? 1 << k : 0;
        }
      });
    std::vector<Id> fixed; // 4 * cell + face
    for (Id c = 0; c < this->NumberOfCells(); ++c)
    {
      for (int k = 0; k < 4; ++k)
      {
        if ((masks[c] >> k & 1) != 0)
        {
          fixed.push_back(4 * c + k);
        }
      }
    }
    std::vector<FacetOfInput> faces(fixed.size());
    ParallelLoop(faces.size(), NanosecondsPerFace,
      [&](std::size_t f) { faces[f] = this->FixedFace(fixed[f] / 4, fixed[f] % 4); });
    return faces;
  }

  RefinableMesh MakeRefinable(const std::vector<FacetOfInput>& fixed) const
  {
    RefinableMesh mesh;
    for (const Id point : this->Points)
    {
      mesh.AddPoint(
        this->Whole.Points[point], PointKind::Free, std::numeric_limits<double>::infinity());
    }
    mesh.SetCells(this->Cells.size(),
      [this](Id c)
      {
        const std::array<Id, 4> none = { { None, None, None, None } };
        RefinableCell cell = { { 0, c, 0 }, this->Whole.Cells[this->Cells[c]], none, none };
        for (int k = 0; k < 4; ++k)
        {
          cell.Corners[k] = this->NumberOfPoint[cell.Corners[k]];
          cell.Neighbors[CornerAcrossFrom[k]] = this->NeighborOf(c, k);
        }
        return cell;
      });
    SetFacets(fixed, mesh);
    return mesh;
  }

  Id NumberOfCells() const { return static_cast<Id>(this->Cells.size()); }

  const TetrahedralMesh& Whole;
  std::vector<Id> Cells;  ///< of the whole mesh, ascending
  std::vector<Id> Points; ///< the same

private:
  /** Per point, whether a chosen cell has it. */
  std::vector<char> PointsOf(const std::vector<char>& chosen) const
  {
    std::vector<char> near(this->Whole.Points.size(), 0);
    ParallelLoop(chosen.size(), NanosecondsPerNeighbor,
      [&](std::size_t c)
      {
        for (int i = 0; i < 4 && chosen[c] != 0; ++i)
        {
          __atomic_store_n(&near[this->Whole.Cells[c][i]], char(1), __ATOMIC_RELAXED);
        }
      });
    return near;
  }

  /** Choose all cells that share a point with a chosen one. */
  void ChooseNeighbors(std::vector<char>& chosen) const
  {
    const std::vector<char> near = this->PointsOf(chosen);
    ParallelLoop(chosen.size(), NanosecondsPerNeighbor,
      [&](std::size_t c)
      {
        const Tetrahedron& cell = this->Whole.Cells[c];
        chosen[c] = near[cell[0]] | near[cell[1]] | near[cell[2]] | near[cell[3]];
      });
  }

  /** Number the chosen ones. @return them, ascending */
  static std::vector<Id> Number(const std::vector<char>& chosen, std::vector<Id>& numbers)
  {
    std::vector<Id> list;
    list.reserve(static_cast<std::size_t>(std::count(chosen.begin(), chosen.end(), 1)));
    for (std::size_t i = 0; i < chosen.size(); ++i)
    {
      if (chosen[i] != 0)
      {
        numbers[i] = static_cast<Id>(list.size());
        list.push_back(static_cast<Id>(i));
      }
    }
    return list;
  }

  FacetOfInput FixedFace(Id cell, int k) const
  {
    const Id neighbor = this->NeighborOf(cell, k);
    Id mirror = None;
    for (int j = 0; j < 4 && neighbor != None; ++j)
    {
      mirror = this->NeighborOf(neighbor, j) == cell ? 4 * neighbor + j : mirror;
    }
    return { CornersOf(this->Whole.Points, FaceOf(this->Whole.Cells[this->Cells[cell]], k)),
      { { 4 * cell + k, mirror } }, 0 };
  }

  std::vector<Id> NumberOfCell;  // per cell of the whole mesh, None if it is not near
  std::vector<Id> NumberOfPoint; // the same
};

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
  auto next = gone.begin();
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    if (next != gone.end() && *next == c)
    {
      ++next;
    }
    else
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

/** A fixed face as the first of its cells sees it. */
struct FaceBefore
{
  bool Turned;
  std::int8_t Side;
  Id Facet;
  Id Neighbor; ///< in the whole mesh
};

std::vector<FaceBefore> FacesBefore(
  const NearFlatCells& near, const std::vector<FacetOfInput>& fixed)
{
  std::vector<FaceBefore> faces(fixed.size());
  ParallelLoop(faces.size(), NanosecondsPerFace,
    [&](std::size_t f)
    {
      const TetrahedralMesh& whole = near.Whole;
      const Id cell = near.Cells[fixed[f].Faces[0] / 4];
      const int k = fixed[f].Faces[0] % 4;
      faces[f] = { SortedTriangle(FaceOf(whole.Cells[cell], k)).Turned, whole.FacetSides[cell][k],
        whole.Facets[cell][k], whole.Neighbors[cell][k] };
    });
  return faces;
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
  const std::vector<FaceBefore> before = FacesBefore(near, fixed);
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
  ParallelLoop(mended.NumberOfCells(), NanosecondsPerFace,
    [&](Id c)
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
          const FaceBefore& face = before[f];
          const bool isSame = SortedTriangle(FaceOf(cell.Corners, k)).Turned == face.Turned;
          facet = face.Facet;
          side = static_cast<std::int8_t>(isSame ? face.Side : -face.Side);
          if (inner == None && face.Neighbor != None)
          {
            neighbor = face.Neighbor;
            SetNeighbor(whole, neighbor, FaceOf(whole.Cells[number], k), number);
          }
        }
        whole.Neighbors[number][k] = neighbor;
        whole.Facets[number][k] = facet;
        whole.FacetSides[number][k] = side;
      }
    });
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
  const std::vector<FacetOfInput> fixed = near.FixedFaces();
  RefinableMesh refinable = near.MakeRefinable(fixed);
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
