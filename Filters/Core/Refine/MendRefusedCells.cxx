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
#include <utility>
#include <vector>

namespace insideout
{
namespace
{
/** Limit of passes: one step may make room for another. */
constexpr int MostPasses = 10;

/** Square of the least sine of a cell that is not flat: volumes of flatter cells have few digits.
 */
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
    for (const Id cell : this->RefusedCells())
    {
      this->MendInside(cell);
    }
    if (this->MayChangeSurface)
    {
      for (const Id cell : this->RefusedCells())
      {
        this->Changes += this->ContractEdges(cell);
        this->Changes += this->IsRefusedCell(cell) && this->RemoveSpike(cell) ? 1 : 0;
      }
    }
    const std::vector<Id> cells = this->RefusedCells();
    this->FindCellsAtCorners(cells);
    for (const Id cell : cells)
    {
      for (int k = 0; k < 4 && this->IsRefusedCell(cell); ++k)
      {
        this->MoveCorner(cell, k);
      }
    }
    return this->Mesh.NumberOfChanges() > before;
  }

  Id ChangesOfSurface() const { return this->Changes; }

private:
  bool IsRefusedCell(Id cell) const
  {
    return !this->Mesh.IsDead(cell) &&
      IsRefused(CornersOf(this->Mesh.Points, this->Mesh.Cell(cell).Corners));
  }

  std::vector<Id> RefusedCells() const
  {
    std::vector<Id> cells;
    for (Id cell = 0; cell < this->Mesh.NumberOfCells(); ++cell)
    {
      if (this->IsRefusedCell(cell))
      {
        cells.push_back(cell);
      }
    }
    return cells;
  }

  void MendInside(Id cell)
  {
    for (int k = 0; k < 4 && this->IsRefusedCell(cell); ++k)
    {
      this->Contract(this->Mesh.Cell(cell).Corners[k]);
    }
    if (this->IsRefusedCell(cell))
    {
      this->Reconnect.ImproveCell(cell);
    }
  }

  /** The number of refused cells and the worst shape if the star's point is contracted. */
  std::pair<Id, double> Contracted(Id target) const
  {
    std::pair<Id, double> result = { 0, 1 };
    for (const Triangle& wall : this->Walls)
    {
      if (!Has(wall, target))
      {
        const std::array<Point, 4> corners =
          CornersOf(this->Mesh.Points, Tetrahedron{ { wall[0], wall[1], wall[2], target } });
        result.first += IsRefused(corners) ? 1 : 0;
        result.second =
          std::min(result.second, ShapeOf(corners[0], corners[1], corners[2], corners[3]));
      }
    }
    return result;
  }

  /** Contract an inner point into the neighbor with which the fewest cells are refused, and of
   * these the one with the best shapes; if they are fewer than before. */
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
    std::pair<Id, double> best = { std::count_if(this->Cells.begin(), this->Cells.end(),
                                     [this](Id cell) { return this->IsRefusedCell(cell); }),
      1 };
    Id chosen = None;
    for (const Id target : targets)
    {
      const auto [refused, worst] = this->Contracted(target);
      if (worst > least && (refused < best.first || (refused == best.first && worst > best.second)))
      {
        best = { refused, worst };
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
      if (!this->IsRefusedCell(cell))
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

  /** Move a corner away from the opposite face, as little as makes the solver accept the cell. */
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
      if (this->MendsBy(cell, corner, place) && (isInner || this->MovesSurface(corner, place)))
      {
        this->Mesh.Move(corner, place, this->Walls);
        this->Changes += isInner ? 0 : 1;
        return;
      }
    }
  }

  /** Whether a move of the star's point mends a cell and makes no other one unfit. */
  bool MendsBy(Id mended, Id point, const Point& place) const
  {
    const std::vector<Point>& points = this->Mesh.Points;
    for (std::size_t i = 0; i < this->Cells.size(); ++i)
    {
      const Id cell = this->Cells[i];
      const auto [a, b, c] = CornersOf(points, this->Walls[i]);
      const double least = cell == mended
        ? FlatShape
        : std::min(ShapeOf(a, b, c, points[point]), ShapeOfAngle(PoorAngle)) / 2;
      std::array<Point, 4> moved = CornersOf(points, this->Mesh.Cell(cell).Corners);
      moved[this->Mesh.CornerIndex(cell, point)] = place;
      if (ShapeOf(a, b, c, place) < least || Orient3D(a, b, c, place) <= 0 ||
        (IsRefused(moved) && (cell == mended || !this->IsRefusedCell(cell))))
      {
        return false;
      }
    }
    return true;
  }

  /** Whether a point of the surface may move; the bound then has its new pieces. */
  bool MovesSurface(Id point, const Point& place)
  {
    std::vector<SurfacePiece> pieces;
    for (const Id cell : this->Cells)
    {
      for (int k = 0; k < 4; ++k)
      {
        if (this->Mesh.Cell(cell).Corners[k] != point && this->Mesh.HasPiece(cell, k))
        {
          pieces.push_back(PieceAt(this->Mesh, cell, k));
        }
      }
    }
    std::vector<SurfacePiece> moved = pieces;
    for (SurfacePiece& piece : moved)
    {
      for (int k = 0; k < 3; ++k)
      {
        piece.Places[k] = piece.Corners[k] == point ? place : piece.Places[k];
      }
    }
    const bool isLocked = std::any_of(pieces.begin(), pieces.end(),
      [this](const SurfacePiece& piece) { return this->Surface.IsLocked(piece.Facet); });
    if (isLocked || !this->Bound.AllowsEach(pieces, pieces, moved))
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
