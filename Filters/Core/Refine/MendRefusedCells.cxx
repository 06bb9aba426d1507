// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/MendRefusedCells.h"

#include "Common/PointPredicates.h"
#include "Common/SortUniquely.h"
#include "Common/Vectors.h"
#include "Quality/SolverFitness.h"
#include "Refine/CellShape.h"
#include "Refine/ContractOnSurface.h"
#include "Refine/ReconnectCells.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace insideout
{
namespace
{
/** Limit of passes: one step may make room for another. */
constexpr int MostPasses = 10;

/** Square of the least sine of a cell that a solver refuses no longer: volumes of flatter cells
 * have few digits. */
constexpr double FlatShape = 1e-20;

/** Degrees. Moves may make angles as small as this, and smaller ones half as good. */
constexpr double PoorAngle = 1;

/** The growth of moves that are tried. */
constexpr double Growth = 4;

template <class Corners>
bool Has(const Corners& corners, Id point)
{
  return std::find(corners.begin(), corners.end(), point) != corners.end();
}

double ShapeOf(const std::array<Point, 4>& corners)
{
  return insideout::ShapeOf(corners[0], corners[1], corners[2], corners[3]);
}

bool IsPositive(const std::array<Point, 4>& corners)
{
  return Orient3D(corners[0], corners[1], corners[2], corners[3]) > 0;
}

bool HasShape(const std::array<Point, 4>& corners, double least)
{
  return ShapeOf(corners) >= least && IsPositive(corners) && !IsRefused(corners);
}

bool IsFit(const std::array<Point, 4>& corners)
{
  return HasShape(corners, FlatSine * FlatSine);
}

/** Whether a refused cell is accepted after a change, or a flat one fit. */
bool IsMended(const std::array<Point, 4>& before, const std::array<Point, 4>& after)
{
  return HasShape(after, IsRefused(before) ? FlatShape : FlatSine * FlatSine);
}

/** The refused and the flat cells, and the worst shape with a minus: less is better. */
using Unfitness = std::tuple<Id, Id, double>;

void Count(const std::array<Point, 4>& corners, Unfitness& sum)
{
  const bool isRefused = IsRefused(corners);
  std::get<0>(sum) += isRefused ? 1 : 0;
  std::get<1>(sum) += !isRefused && !IsFit(corners) ? 1 : 0;
}

class RefusedCellMending : public SurfaceOperator
{
public:
  RefusedCellMending(RefinableMesh& mesh, RefinableSurface& surface, SurfaceBound& bound,
    double distance, bool mayChangeSurface)
    : SurfaceOperator(mesh, surface, bound)
    , MostDistance(distance)
    , MayChangeSurface(mayChangeSurface)
  {
  }

  /** @return whether anything was changed */
  bool Pass()
  {
    const std::int64_t before = this->Mesh.NumberOfChanges();
    const std::vector<Id> given = this->UnfitCells();
    if (given.empty())
    {
      return false;
    }
    for (const Id cell : given)
    {
      this->MendInside(cell);
    }
    if (this->MayChangeSurface)
    {
      for (const Id cell : this->UnfitCells())
      {
        this->Changes += this->ContractEdges(cell);
        this->Changes += this->IsUnfit(cell) && this->RemoveSpike(cell) ? 1 : 0;
      }
    }
    const std::vector<Id> cells = this->UnfitCells();
    this->FindCellsAtCorners(cells);
    for (const Id cell : cells)
    {
      for (int axis = 0; axis < 3 && this->MayChangeSurface && this->IsUnfit(cell); ++axis)
      {
        this->Stretch(cell, axis);
      }
      for (int k = 0; k < 4 && this->IsUnfit(cell); ++k)
      {
        this->MoveCorner(cell, k);
      }
    }
    return this->Mesh.NumberOfChanges() > before;
  }

  Id ChangesOfSurface() const { return this->Changes; }

private:
  bool IsUnfit(Id cell) const { return !this->Mesh.IsDead(cell) && !IsFit(this->PlacesOf(cell)); }

  std::vector<Id> UnfitCells() const
  {
    std::vector<Id> cells;
    for (Id cell = 0; cell < this->Mesh.NumberOfCells(); ++cell)
    {
      if (this->IsUnfit(cell))
      {
        cells.push_back(cell);
      }
    }
    return cells;
  }

  void MendInside(Id cell)
  {
    for (int k = 0; k < 4 && this->IsUnfit(cell); ++k)
    {
      this->Contract(this->Mesh.Cell(cell).Corners[k]);
    }
    if (this->IsUnfit(cell))
    {
      this->Reconnect.ImproveCell(cell);
    }
  }

  /** The star's cells if its point is contracted. */
  Unfitness Contracted(Id target) const
  {
    Unfitness result = { 0, 0, -1 };
    for (const Triangle& wall : this->Walls)
    {
      if (!Has(wall, target))
      {
        const std::array<Point, 4> corners =
          CornersOf(this->Mesh.Points, Tetrahedron{ { wall[0], wall[1], wall[2], target } });
        Count(corners, result);
        std::get<2>(result) = std::max(std::get<2>(result), -ShapeOf(corners));
      }
    }
    return result;
  }

  /** Contract an inner point into the neighbor with which the fewest cells are refused, then flat,
   * and of these the one with the best shapes; if they are fewer than before. */
  void Contract(Id point)
  {
    if (this->Mesh.Kinds[point] != PointKind::Free)
    {
      return;
    }
    this->Mesh.StarWithWalls(point, this->Cells, this->Walls);
    std::vector<Id> targets;
    for (const Triangle& wall : this->Walls)
    {
      targets.insert(targets.end(), wall.begin(), wall.end());
    }
    SortUniquely(targets);
    const double least = std::min(std::max(WorstShapeOf(this->Mesh, this->Cells), 0.0), FlatShape);
    Unfitness best = { 0, 0, -1 };
    for (const Id cell : this->Cells)
    {
      Count(this->PlacesOf(cell), best);
    }
    Id chosen = None;
    for (const Id target : targets)
    {
      const Unfitness contracted = this->Contracted(target);
      if (-std::get<2>(contracted) > least && contracted < best)
      {
        best = contracted;
        chosen = target;
      }
    }
    std::vector<Tetrahedron> fresh;
    for (const Triangle& wall : this->Walls)
    {
      if (chosen != None && !Has(wall, chosen))
      {
        fresh.push_back({ { wall[0], wall[1], wall[2], chosen } });
      }
    }
    const bool arePositive = std::all_of(fresh.begin(), fresh.end(),
      [this](const Tetrahedron& cell) { return Orient3D(this->Mesh.Points, cell) > 0; });
    if (!fresh.empty() && arePositive)
    {
      this->Mesh.Replace(this->Cells, fresh);
    }
  }

  /** Contract short edges of the surface. @return the number of those */
  Id ContractEdges(Id cell)
  {
    Id count = 0;
    for (const auto& [i, j] : TetrahedronEdges)
    {
      if (!this->IsUnfit(cell))
      {
        break;
      }
      const Tetrahedron& corners = this->Mesh.Cell(cell).Corners;
      const Edge ends = { { corners[i], corners[j] } };
      count += this->ContractEdge(ends[0], ends[1]) || this->ContractEdge(ends[1], ends[0]) ? 1 : 0;
    }
    return count;
  }

  bool ContractEdge(Id point, Id target)
  {
    if (this->Mesh.Kinds[point] == PointKind::Free || this->Mesh.Kinds[target] == PointKind::Free ||
      Distance(this->Mesh.Points[point], this->Mesh.Points[target]) > this->MostDistance)
    {
      return false;
    }
    this->Cells.clear();
    this->Mesh.Star(point, this->Cells);
    const double worst = std::max(WorstShapeOf(this->Mesh, this->Cells), 0.0);
    return this->OnSurface.ContractStep(point, target, std::min(worst, FlatShape));
  }

  /** Remove a cell with three faces on the boundary. */
  bool RemoveSpike(Id cell)
  {
    const RefinableCell spike = this->Mesh.Cell(cell);
    std::vector<SurfacePiece> gone;
    int inner = 0;
    for (int k = 0; k < 4; ++k)
    {
      if (spike.Neighbors[k] == None)
      {
        gone.push_back(PieceAt(this->Mesh, cell, k));
      }
      else
      {
        inner = k;
      }
    }
    if (gone.size() != 3 || spike.Facets[inner] != None)
    {
      return false;
    }
    const SurfacePiece largest = *std::max_element(gone.begin(), gone.end(),
      [](const SurfacePiece& a, const SurfacePiece& b)
      { return Length(NormalOf(a)) < Length(NormalOf(b)); });
    const auto [a, b, c] = this->Mesh.FaceCorners(cell, inner);
    const Triangle face = { { a, c, b } }; // as the cell behind it sees it
    std::vector<SurfacePiece> fresh = { { face, CornersOf(this->Mesh.Points, face),
      largest.Facet } };
    if (!this->Bound.AllowsEach({ largest }, gone, fresh))
    {
      return false;
    }
    CellExchange exchange;
    exchange.Old = { cell };
    ExchangePieces(gone, fresh, exchange);
    this->Bound.Replace();
    this->Mesh.Replace(exchange);
    this->FindCellAt(spike.Corners[inner]);
    return true;
  }

  /** A pinched point that has lost its cell may be a corner of others. */
  void FindCellAt(Id point)
  {
    for (Id cell = 0; this->Surface.IsPinched(point) && cell < this->Mesh.NumberOfCells(); ++cell)
    {
      if (!this->Mesh.IsDead(cell) && Has(this->Mesh.Cell(cell).Corners, point))
      {
        this->Mesh.SetCellAt(point, cell);
        return;
      }
    }
  }

  /** The cells at all corners of some cells: also those that a pinched corner's star lacks. */
  void FindCellsAtCorners(const std::vector<Id>& cells)
  {
    std::vector<char> isCorner(this->Mesh.Points.size(), 0);
    for (const Id cell : cells)
    {
      for (const Id corner : this->Mesh.Cell(cell).Corners)
      {
        isCorner[corner] = 1;
      }
    }
    this->AtCorners.clear();
    for (Id cell = 0; cell < this->Mesh.NumberOfCells() && !cells.empty(); ++cell)
    {
      for (int k = 0; k < 4 && !this->Mesh.IsDead(cell); ++k)
      {
        if (const Id corner = this->Mesh.Cell(cell).Corners[k]; isCorner[corner] != 0)
        {
          this->AtCorners.push_back({ corner, cell });
        }
      }
    }
    std::sort(this->AtCorners.begin(), this->AtCorners.end());
  }

  /** Move a corner away from the opposite face, as little as makes the cell fit. */
  void MoveCorner(Id cell, int k)
  {
    const Id corner = this->Mesh.Cell(cell).Corners[k];
    const bool isInner = this->Mesh.Kinds[corner] == PointKind::Free;
    const auto [a, b, c] = CornersOf(this->Mesh.Points, this->Mesh.FaceCorners(cell, k));
    const Point normal = NormalOf(a, b, c);
    const double length = Length(normal);
    if (!(length > 0) || !(isInner || this->MayChangeSurface))
    {
      return;
    }
    this->Cells.clear();
    this->Walls.clear();
    for (auto at = std::lower_bound(
           this->AtCorners.begin(), this->AtCorners.end(), std::pair<Id, Id>(corner, 0));
         at != this->AtCorners.end() && at->first == corner; ++at)
    {
      const Id other = at->second;
      this->Cells.push_back(other);
      this->Walls.push_back(this->Mesh.FaceCorners(other, this->Mesh.CornerIndex(other, corner)));
    }
    const Point from = this->Mesh.Points[corner];
    for (double step = 2 * SmallestJacobian / length; step <= this->MostDistance; step *= Growth)
    {
      const double t = step / length;
      const Point place = { { from[0] + t * normal[0], from[1] + t * normal[1],
        from[2] + t * normal[2] } };
      const auto placeOf = [&](Id point)
      { return point == corner ? place : this->Mesh.Points[point]; };
      if (this->MendsBy(cell, placeOf) && this->MovesSurface(this->Cells, placeOf))
      {
        this->Mesh.Move(corner, place, this->Walls);
        this->Changes += isInner ? 0 : 1;
        return;
      }
    }
  }

  /** Whether a move of the star's point mends a cell and makes no other one unfit. */
  template <class PlaceOf>
  bool MendsBy(Id mended, const PlaceOf& placeOf) const
  {
    for (const Id cell : this->Cells)
    {
      const std::array<Point, 4> moved = this->PlacesOf(cell, placeOf);
      if (cell == mended ? !IsMended(this->PlacesOf(cell), moved) : !this->StaysFit(cell, moved))
      {
        return false;
      }
    }
    return true;
  }

  /** Whether a cell with moved corners is positive, and not much worse than before. */
  bool StaysFit(Id cell, const std::array<Point, 4>& moved) const
  {
    const std::array<Point, 4> now = this->PlacesOf(cell);
    return ShapeOf(moved) >= std::min(ShapeOf(now), ShapeOfAngle(PoorAngle)) / 2 &&
      IsPositive(moved) && (!IsRefused(moved) || IsRefused(now)) && (IsFit(moved) || !IsFit(now));
  }

  /**
   * Multiply a coordinate of flat cells that are stacked near 0, where doubles are so dense that
   * even a cell of coplanar points has a volume: a corner that moves alone would turn its neighbors
   * over. Powers of 2 keep all their digits, so that all volumes grow alike.
   */
  void Stretch(Id cell, int axis)
  {
    double extent = 0;
    for (const Id corner : this->Mesh.Cell(cell).Corners)
    {
      extent = std::max(extent, std::abs(this->Mesh.Points[corner][axis]));
    }
    for (double factor = Growth; factor * extent <= this->MostDistance; factor *= Growth)
    {
      if (this->StretchBy(cell, axis, factor))
      {
        return;
      }
    }
  }

  /** The same with one factor, and with all flat cells that would turn over otherwise. */
  bool StretchBy(Id mended, int axis, double factor)
  {
    std::set<Id> stretched;
    const auto placeOf = [&](Id point)
    {
      Point place = this->Mesh.Points[point];
      place[axis] *= stretched.count(point) > 0 ? factor : 1;
      return place;
    };
    std::vector<Id> unfit = { mended };
    while (!unfit.empty())
    {
      const std::size_t before = stretched.size();
      for (const Id cell : unfit)
      {
        const Tetrahedron& corners = this->Mesh.Cell(cell).Corners;
        stretched.insert(corners.begin(), corners.end());
      }
      if (stretched.size() == before)
      {
        return false;
      }
      this->Cells.clear();
      for (const Id point : stretched)
      {
        if (this->Surface.IsPinched(point) ||
          std::abs(factor * this->Mesh.Points[point][axis]) > this->MostDistance)
        {
          return false;
        }
        this->Mesh.Star(point, this->Cells);
      }
      SortUniquely(this->Cells);
      unfit.clear();
      std::copy_if(this->Cells.begin(), this->Cells.end(), std::back_inserter(unfit),
        [&](Id cell) { return !this->StaysFit(cell, this->PlacesOf(cell, placeOf)); });
    }
    if (!IsMended(this->PlacesOf(mended), this->PlacesOf(mended, placeOf)) ||
      !this->MovesSurface(this->Cells, placeOf))
    {
      return false;
    }
    for (const Id point : stretched)
    {
      this->Mesh.StarWithWalls(point, this->Cells, this->Walls);
      this->Mesh.Move(point, placeOf(point), this->Walls);
    }
    ++this->Changes;
    return true;
  }

  std::array<Point, 4> PlacesOf(Id cell) const
  {
    return CornersOf(this->Mesh.Points, this->Mesh.Cell(cell).Corners);
  }

  template <class PlaceOf>
  std::array<Point, 4> PlacesOf(Id cell, const PlaceOf& placeOf) const
  {
    const Tetrahedron& corners = this->Mesh.Cell(cell).Corners;
    std::array<Point, 4> places;
    std::transform(corners.begin(), corners.end(), places.begin(), placeOf);
    return places;
  }

  /** Whether points of the surface may move; the bound then has its new pieces. */
  template <class PlaceOf>
  bool MovesSurface(const std::vector<Id>& cells, const PlaceOf& placeOf)
  {
    std::vector<SurfacePiece> pieces;
    std::vector<SurfacePiece> moved;
    for (const Id cell : cells)
    {
      for (int k = 0; k < 4; ++k)
      {
        if (this->Mesh.HasPiece(cell, k))
        {
          const SurfacePiece piece = PieceAt(this->Mesh, cell, k);
          SurfacePiece there = piece;
          std::transform(piece.Corners.begin(), piece.Corners.end(), there.Places.begin(), placeOf);
          if (there.Places != piece.Places)
          {
            pieces.push_back(piece);
            moved.push_back(there);
          }
        }
      }
    }
    const bool isLocked = std::any_of(pieces.begin(), pieces.end(),
      [this](const SurfacePiece& piece) { return this->Surface.IsLocked(piece.Facet); });
    if (pieces.empty())
    {
      return true;
    }
    if (isLocked || !this->Bound.AllowsMove(pieces, moved))
    {
      return false;
    }
    this->Bound.Replace();
    return true;
  }

  const double MostDistance;
  const bool MayChangeSurface;
  Id Changes = 0; ///< of the surface
  Reconnection Reconnect{ this->Mesh, this->Surface, this->Bound };
  SurfaceContraction OnSurface{ this->Mesh, this->Surface, this->Bound };
  std::vector<Id> Cells; ///< around a point
  std::vector<Triangle> Walls;
  std::vector<std::pair<Id, Id>> AtCorners; ///< (corner, cell), sorted
};
} // namespace

Id MendRefusedCells(RefinableMesh& mesh, RefinableSurface& surface, SurfaceBound& bound,
  double distance, bool mayChangeSurface, Monitor& monitor, const ProgressRange& progress)
{
  RefusedCellMending mending(mesh, surface, bound, distance, mayChangeSurface);
  for (int pass = 0; pass < MostPasses && mending.Pass(); ++pass)
  {
    monitor.Check(progress, static_cast<double>(pass) / MostPasses);
  }
  return mending.ChangesOfSurface();
}
} // namespace insideout
