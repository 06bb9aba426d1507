// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/ImproveCells.h"

#include "Common/LoopProgress.h"
#include "Common/Vectors.h"
#include "Refine/CellShape.h"
#include "Refine/ContractEdge.h"
#include "Refine/ContractOnSurface.h"
#include "Refine/InsertPoint.h"
#include "Refine/ReconnectCells.h"
#include "Refine/SmoothPoint.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace insideout
{
namespace
{
/** Degrees. Cells with all dihedral angles between this and 180 minus this are left alone: a higher
 * value spends most of the time on good cells. */
constexpr double GoodAngle = 22;

/** The same where the surface obstructs less. */
constexpr double GoodAngleWhereSplit = 30;
constexpr double GoodAngleWhereRemeshed = 34;

/** Cells with an angle below this, in degrees, may be improved by an additional point. */
constexpr double AngleForPoint = 20;

/** From this pass on, long edges of flat cells are split; the passes before have removed most. */
constexpr int FirstPassOfLongEdges = 2;

/** Cells with an angle below this, in degrees, get a point beside them where none fits in them. */
constexpr double FlatAngle = 1;

/** Least relative gains, so that improvement terminates; an additional point costs cells. */
constexpr double LeastGain = 1.0001;
constexpr double LeastGainByPoint = 1.2;

/** Limit of cells that an additional point replaces. In flat regions there are hundreds, and the
 * new cells are hardly ever better. */
constexpr std::size_t LargestCavity = 25;

/** Limit of an edge's length, relative to the wanted one, when a point is removed. */
constexpr double LongestEdge = 1.8;

/** The same for edges that are split after the last pass, whose cells are not improved any more. */
constexpr double LongestEdgeInTheEnd = 2;

/** Degrees. If the surface is remeshed to wanted lengths, interior edges that are still too long
 * get a midpoint. No cell may get an angle smaller than this and than the old ones. */
constexpr double AngleAmidLongEdge = 10;
constexpr std::size_t LargestCavityAmidLongEdge = 100;

double GoodAngleWhere(SurfaceTreatment treatment)
{
  return treatment == SurfaceTreatment::Kept ? GoodAngle
    : treatment == SurfaceTreatment::Split   ? GoodAngleWhereSplit
                                             : GoodAngleWhereRemeshed;
}

/** Per point or cell, the time of the last attempt, counted in changes of the mesh. */
using Tries = std::vector<std::int64_t>;

class Improvement
{
public:
  Improvement(
    RefinableMesh& mesh, RefinableSurface& surface, SurfaceBound& bound, SizingField& sizes)
    : Mesh(mesh)
    , Sizes(sizes)
    , Reconnect(mesh, surface, bound)
    , Smooth(mesh, surface, bound)
    , Contract(mesh)
    , ContractOnSurface(mesh, surface, bound)
    , IsRemeshed(surface.Treatment() == SurfaceTreatment::Remeshed)
    , Good(ShapeOfAngle(GoodAngleWhere(surface.Treatment())))
    , Insert(mesh)
  {
  }

  /** The cells that are not good and whose surroundings changed, worst first. */
  std::vector<std::pair<double, Id>> BadCells(std::int64_t since) const
  {
    std::vector<std::pair<double, Id>> cells;
    for (Id cell = 0; cell < this->Mesh.NumberOfCells(); ++cell)
    {
      if (!this->Mesh.IsDead(cell) && this->LastChangeAt(cell) > since)
      {
        const double shape = this->ShapeOfCell(cell);
        if (shape < this->Good)
        {
          cells.push_back({ shape, cell });
        }
      }
    }
    std::sort(cells.begin(), cells.end());
    return cells;
  }

  /** @param[in] mayAdd whether points may be added */
  void Improve(Id cell, bool mayAdd)
  {
    if (this->Mesh.IsDead(cell))
    {
      return;
    }
    const double shape = this->ShapeOfCell(cell);
    const bool getsPoint = mayAdd && shape < this->Flat; // passes before have added none
    if (shape >= this->Good ||
      !(this->IsNew(cell, this->LastChangeAt(cell), this->TriedAt) || getsPoint) ||
      this->Reconnect.ImproveCell(cell))
    {
      return;
    }
    const Tetrahedron corners = this->Mesh.Cell(cell).Corners;
    if (!this->MoveCorners(corners) && !this->RemoveCorner(corners) && mayAdd)
    {
      this->AddPoint(cell);
    }
  }

  /**
   * Split interior edges that are far too long, if lengths are wanted and the surface follows them.
   * @param[in] longest relative to the wanted length
   */
  void CutLongEdges(double longest)
  {
    const Id count = this->IsRemeshed && this->Sizes.IsAskedFor() ? this->Mesh.NumberOfCells() : 0;
    for (Id cell = 0; cell < count; ++cell)
    {
      const Tetrahedron corners = this->Mesh.Cell(cell).Corners;
      const Id version = this->Mesh.Cell(cell).Version;
      for (const auto& [i, j] : TetrahedronEdges)
      {
        if (!this->Mesh.IsDead(cell) && this->Mesh.Cell(cell).Version == version)
        {
          this->CutIfLong(cell, corners[i], corners[j], longest);
        }
      }
    }
  }

private:
  void CutIfLong(Id cell, Id u, Id v, double longest)
  {
    const std::vector<Point>& points = this->Mesh.Points;
    const Point middle = Midpoint(points[u], points[v]);
    const double size = this->Sizes.At(cell, middle);
    if (!(Distance(points[u], points[v]) > longest * size) ||
      !this->Insert.Find(cell, middle, LargestCavityAmidLongEdge))
    {
      return;
    }
    const double before = std::max(0.0, this->Insert.WorstShapeBefore());
    if (this->Insert.OptimizePlace() > std::min(before, this->GoodAmidLongEdge))
    {
      this->Sizes.Append(this->Insert.Holder(), middle);
      this->Insert.Insert(size);
    }
  }

  double ShapeOfCell(Id cell) const
  {
    return ShapeOf(this->Mesh.Points, this->Mesh.Cell(cell).Corners);
  }

  std::int64_t LastChangeAt(Id cell) const
  {
    std::int64_t last = 0;
    for (const Id corner : this->Mesh.Cell(cell).Corners)
    {
      last = std::max(last, this->Mesh.LastChangeAround(corner));
    }
    return last;
  }

  /** Whether anything has changed around a point or cell since this was asked last. */
  bool IsNew(Id which, std::int64_t lastChange, Tries& tries)
  {
    const auto size = std::max<std::size_t>(this->Mesh.Points.size(), this->Mesh.NumberOfCells());
    tries.resize(size, None);
    const bool isNew = lastChange > tries[which];
    tries[which] = this->Mesh.NumberOfChanges();
    return isNew;
  }

  bool IsNewPoint(Id point, Tries& tries)
  {
    return this->IsNew(point, this->Mesh.LastChangeAround(point), tries);
  }

  bool MoveCorners(const Tetrahedron& corners)
  {
    bool isMoved = false;
    for (const Id corner : corners)
    {
      if (this->IsNewPoint(corner, this->SmoothedAt) && this->Smooth.Smooth(corner))
      {
        isMoved = true;
        if (ShapeOf(this->Mesh.Points, corners) >= this->Good)
        {
          break;
        }
      }
    }
    return isMoved;
  }

  bool RemoveCorner(const Tetrahedron& corners)
  {
    return std::any_of(corners.begin(), corners.end(),
      [this](Id corner)
      {
        if (!this->IsNewPoint(corner, this->RemovedAt))
        {
          return false;
        }
        const PointKind kind = this->Mesh.Kinds[corner];
        if (kind != PointKind::Free && (kind == PointKind::Fixed || !this->IsRemeshed))
        {
          return false;
        }
        const double wanted = std::max(0.0, this->Contract.WorstAround(corner)) * LeastGain;
        return kind == PointKind::Free
          ? this->Contract.Remove(corner, wanted, LongestEdge)
          : this->ContractOnSurface.Remove(corner, wanted, LongestEdge);
      });
  }

  void AddPoint(Id cell)
  {
    const double shape = this->ShapeOfCell(cell);
    if (shape >= this->BadForPoint)
    {
      return;
    }
    const Point middle = Barycentre(this->Mesh.Points, this->Mesh.Cell(cell).Corners);
    bool isAdded = this->Insert.Find(cell, middle, LargestCavity) && this->AddFoundPoint(middle, 0);
    for (int k = 0; k < 4 && !isAdded && shape < this->Flat; ++k)
    {
      isAdded =
        this->Insert.FindBeside(cell, k, LargestCavity) && this->AddFoundPoint(middle, this->Flat);
    }
  }

  /** Insert the place that was found, if the new cells' shapes are above those before and `least`.
   * @param[in] near where the size is taken */
  bool AddFoundPoint(const Point& near, double least)
  {
    const double before = std::max(0.0, this->Insert.WorstShapeBefore());
    if (!(this->Insert.OptimizePlace() > std::max(before * LeastGainByPoint, least)))
    {
      return false;
    }
    const double size = this->Sizes.At(this->Insert.Holder(), near);
    this->Sizes.Append(this->Insert.Holder(), near);
    this->Insert.Insert(size);
    return true;
  }

  const double BadForPoint = ShapeOfAngle(AngleForPoint);
  const double Flat = ShapeOfAngle(FlatAngle);
  const double GoodAmidLongEdge = ShapeOfAngle(AngleAmidLongEdge);
  RefinableMesh& Mesh;
  SizingField& Sizes;
  Reconnection Reconnect;
  PointSmoothing Smooth;
  Contraction Contract;
  SurfaceContraction ContractOnSurface;
  const bool IsRemeshed;
  const double Good; ///< shape
  PointInsertion Insert;
  Tries TriedAt; ///< cells
  Tries SmoothedAt;
  Tries RemovedAt;
};
} // namespace

void ImproveCells(RefinableMesh& mesh, RefinableSurface& surface, SurfaceBound& bound,
  SizingField& sizes, Monitor& monitor, const ProgressRange& progress, std::int64_t since,
  int passes)
{
  Improvement improvement(mesh, surface, bound, sizes);
  for (int pass = 0; pass < passes; ++pass)
  {
    if (pass >= FirstPassOfLongEdges)
    {
      improvement.CutLongEdges(LongestEdge);
    }
    const std::vector<std::pair<double, Id>> cells = improvement.BadCells(since);
    const ProgressRange part = { progress.Stage, progress.At(static_cast<double>(pass) / passes),
      progress.At(static_cast<double>(pass + 1) / passes) };
    const LoopProgress looked(monitor, part, cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      looked.Check(i);
      improvement.Improve(cells[i].second, pass > 0);
    }
  }
  improvement.CutLongEdges(LongestEdgeInTheEnd);
}
} // namespace insideout
