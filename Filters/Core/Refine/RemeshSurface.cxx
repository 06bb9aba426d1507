// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/RemeshSurface.h"

#include "Common/LoopProgress.h"
#include "Common/Vectors.h"
#include "Refine/CellShape.h"
#include "Refine/ContractEdge.h"
#include "Refine/ContractOnSurface.h"
#include "Refine/EdgeLengths.h"
#include "Refine/InsertOnSurface.h"
#include "Refine/ReconnectCells.h"
#include "Refine/SmoothPoint.h"
#include "Refine/SplitEdge.h"

#include <algorithm>
#include <deque>
#include <limits>
#include <tuple>
#include <unordered_map>
#include <vector>

namespace insideout
{
namespace
{
/** Edges longer than this are split even if the split makes flat cells. */
constexpr double LongestUncut = 4;

/** Relative to the same length: the largest circumradius of a piece before it is split (0.58 for a
 * regular triangle), and the least distance of its center to other points. */
constexpr double LargestRadius = 0.7;
constexpr double LeastSpacing = 0.6;

/** Ridges of at least this relative length are split for pieces that are too large. */
constexpr double SplittableEdge = 1;

constexpr std::size_t TurnsBetweenReports = 1000;

/**
 * Degrees. Cells may get angles down to this for the sake of the surface: most are repaired later.
 */
constexpr double AcceptableAngle = 3;

/** The same where edges are contracted to wanted lengths. */
constexpr double AcceptableAngleForLength = 0.3;

/** Rounds of points, flips and moves of a split surface. */
constexpr int RoundsWhereSplit = 2;

/** Limit of rounds of flips before points are added to a split surface: most surfaces take few. */
constexpr int MostRoundsOfTurns = 20;

/** An edge of facets, one of its cells, and its relative length. */
struct SurfaceEdge
{
  double Ratio;
  Edge Ends;
  Id Cell;
  Id Version; ///< version of the cell: if it has changed, the edge may not exist any more

  bool operator<(const SurfaceEdge& other) const
  {
    return std::tie(this->Ratio, this->Ends, this->Cell) <
      std::tie(other.Ratio, other.Ends, other.Cell);
  }
};

/** For stages without measurable progress: reports only that work goes on. */
ProgressRange AtEndOf(const ProgressRange& progress)
{
  return { progress.Stage, progress.End, progress.End };
}

class SurfaceRemeshing : public SurfaceOperator
{
public:
  SurfaceRemeshing(
    RefinableMesh& mesh, RefinableSurface& surface, SurfaceBound& bound, SizingField& sizes)
    : SurfaceOperator(mesh, surface, bound)
    , Sizes(sizes)
  {
  }

  /** Insert points on ridges that are too long, then within facets (Ruppert 1995). */
  void FillFacets(Monitor& monitor, const ProgressRange& progress)
  {
    this->SplitLongEdges(monitor, progress);
    std::deque<Candidate> queue;
    for (Id c = 0; c < this->Mesh.NumberOfCells(); ++c)
    {
      this->AddPiecesOf(c, queue);
    }
    for (std::size_t turn = 0; !queue.empty(); ++turn)
    {
      if (turn % TurnsBetweenReports == 0)
      {
        monitor.Check(progress.Stage, progress.End);
      }
      const Candidate next = queue.front();
      queue.pop_front();
      if (!this->Mesh.IsDead(next.Piece.Cell) &&
        this->Mesh.Cell(next.Piece.Cell).Version == next.Version)
      {
        this->InsertAmid(next, queue);
      }
    }
  }

  void SplitLongEdges(Monitor& monitor, const ProgressRange& progress)
  {
    for (int round = 0; round < MostRoundsOfSplits; ++round)
    {
      std::vector<SurfaceEdge> edges =
        this->EdgesWithin(LongestEdge, std::numeric_limits<double>::infinity());
      std::reverse(edges.begin(), edges.end());
      std::size_t splits = 0;
      const double part = progress.At(static_cast<double>(round) / MostRoundsOfSplits);
      const LoopProgress looked(monitor, { progress.Stage, part, part }, edges.size());
      for (std::size_t i = 0; i < edges.size(); ++i)
      {
        looked.Check(i);
        const SurfaceEdge& edge = edges[i];
        if (this->IsThere(edge) && this->MaySplit(edge) && this->HasChanged(edge.Ends))
        {
          const bool isSplit = this->SplitEdge({ edge.Ends, edge.Cell });
          splits += isSplit ? 1 : 0;
        }
      }
      if (splits == 0)
      {
        return;
      }
    }
  }

  void ContractShortEdges(Monitor& monitor, const ProgressRange& progress)
  {
    const std::vector<SurfaceEdge> edges = this->EdgesWithin(0, ShortestEdge);
    const LoopProgress looked(monitor, AtEndOf(progress), edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i)
    {
      looked.Check(i);
      const SurfaceEdge& edge = edges[i];
      if (this->IsThere(edge) && !this->ContractInto(edge.Ends[0], edge.Ends[1]))
      {
        this->ContractInto(edge.Ends[1], edge.Ends[0]);
      }
    }
  }

  /** Flip edges that are no Delaunay edges. @return the number of flips */
  std::size_t TurnDiagonals(Monitor& monitor, const ProgressRange& progress)
  {
    const std::vector<SurfaceEdge> edges =
      this->EdgesWithin(0, std::numeric_limits<double>::infinity());
    const LoopProgress looked(monitor, AtEndOf(progress), edges.size());
    std::size_t turns = 0;
    for (std::size_t i = 0; i < edges.size(); ++i)
    {
      looked.Check(i);
      const SurfaceEdge& edge = edges[i];
      const auto [u, v] = edge.Ends;
      if (this->IsThere(edge) && !this->Surface.IsRidge(u, v) && this->IsBadDiagonal(edge) &&
        this->Reconnect.RemoveEdgeUnlessWorse(u, v, edge.Cell, this->Acceptable))
      {
        ++turns;
      }
    }
    return turns;
  }

  void MovePoints(Monitor& monitor, const ProgressRange& progress)
  {
    const LoopProgress looked(monitor, AtEndOf(progress), this->Mesh.Points.size());
    for (Id p = 0; p < static_cast<Id>(this->Mesh.Points.size()); ++p)
    {
      looked.Check(static_cast<std::size_t>(p));
      if (this->Mesh.CellAt(p) != None)
      {
        this->Smooth.Relax(p, this->Acceptable);
      }
    }
  }

private:
  bool ContractInto(Id point, Id target)
  {
    const bool isAskedFor = this->Sizes.IsAskedFor();
    const double acceptable = isAskedFor ? this->AcceptableForLength : this->Acceptable;
    const auto contract = [&]
    {
      const double before = std::max(this->InSolid.WorstAround(point), 0.0);
      return this->Contract.Contract(
        point, target, std::min(acceptable, before / 2), LongestContracted);
    };
    if (!contract() && isAskedFor)
    {
      this->ImproveAround(point); // obstructing cells are replaced
      return contract();
    }
    return this->Mesh.CellAt(point) == None;
  }

  /** A piece to check, and the version of its cell, which tells whether it still exists. */
  struct Candidate
  {
    PieceOfCell Piece;
    Id Version;
  };

  /** Insert points within split facets where circumcircles are large. */
  bool MaySplit(const SurfaceEdge& edge) const
  {
    return this->Surface.Treatment() == SurfaceTreatment::Remeshed ||
      this->Surface.IsRidge(edge.Ends[0], edge.Ends[1]);
  }

  bool SplitEdge(const EdgeOfCell& edge)
  {
    const bool isSplit = this->Surface.Treatment() == SurfaceTreatment::Split;
    const auto mayHalve = [&]
    { return this->Splitting.Find(edge.Ends[0], edge.Ends[1], edge.Cell); };
    if ((isSplit || mayHalve()) && this->Insertion.FindOnEdge(edge) &&
      this->Insertion.Insert(this->Sizes))
    {
      return true;
    }
    // Halves of cells are flat: on a remeshed surface the edge may be flipped.
    if ((isSplit || this->RatioOf(edge.Ends) > LongestUncut) && mayHalve())
    {
      this->ImproveAround(this->Splitting.Split(this->Sizes));
      return true;
    }
    return false;
  }

  /** Replace flat cells. */
  void ImproveAround(Id point)
  {
    std::vector<Id> star;
    this->Mesh.Star(point, star);
    for (const Id cell : star)
    {
      if (!this->Mesh.IsDead(cell))
      {
        this->Reconnect.ImproveCell(cell);
      }
    }
  }

  /**
   * Whether the surroundings of the ends have changed since the last call: otherwise the result is
   * the same.
   */
  bool HasChanged(const Edge& ends)
  {
    const auto [tried, isNew] = this->SplitTriedAt.emplace(ends, 0);
    const bool hasChanged = isNew ||
      std::max(this->Mesh.LastChangeAround(ends[0]), this->Mesh.LastChangeAround(ends[1])) >
        tried->second;
    tried->second = this->Mesh.NumberOfChanges();
    return hasChanged;
  }

  void AddPiecesOf(Id cell, std::deque<Candidate>& queue) const
  {
    for (int k = 0; k < 4 && !this->Mesh.IsDead(cell); ++k)
    {
      if (this->Mesh.Cell(cell).Facets[k] != None)
      {
        queue.push_back({ { cell, k }, this->Mesh.Cell(cell).Version });
      }
    }
  }

  void AddFresh(std::deque<Candidate>& queue) const
  {
    for (const Id cell : this->Mesh.Fresh())
    {
      this->AddPiecesOf(cell, queue);
    }
  }

  /** Insert the center of a piece's circumcircle if that is too large, or the midpoint of a ridge
   * that is between or too near. */
  void InsertAmid(const Candidate& candidate, std::deque<Candidate>& queue)
  {
    const Id cell = candidate.Piece.Cell;
    const std::array<Point, 3> t =
      CornersOf(this->Mesh.Points, FaceAcross(this->Mesh.Cell(cell).Corners, candidate.Piece.Face));
    const Circumsphere circle = CircumcircleOf(t);
    const double size = this->SizeIn(candidate.Piece);
    if (!(circle.SquaredRadius > LargestRadius * LargestRadius * size * size))
    {
      return;
    }
    EdgeOfCell ridge;
    if (this->Insertion.FindOnFacet(candidate.Piece, circle.Center))
    {
      const double there = this->Insertion.SizeThere(this->Sizes);
      ridge = this->Insertion.Encroached();
      if (ridge.Cell == None &&
        this->Insertion.SquaredSpacing() >= LeastSpacing * LeastSpacing * there * there)
      {
        if (this->Insertion.Insert(this->Sizes))
        {
          this->AddFresh(queue);
        }
        return;
      }
    }
    else
    {
      ridge = this->Insertion.Ridge();
    }
    if (ridge.Cell != None && this->RatioOf(ridge.Ends) > SplittableEdge && this->SplitEdge(ridge))
    {
      this->AddFresh(queue);
    }
  }

  double SizeIn(const PieceOfCell& piece) const
  {
    double sum = 0;
    for (const Id corner : FaceAcross(this->Mesh.Cell(piece.Cell).Corners, piece.Face))
    {
      sum += this->Mesh.Sizes[corner] / 3;
    }
    return sum;
  }

  /** The length of an edge relative to the required one. */
  double RatioOf(const Edge& ends) const
  {
    return Distance(this->Mesh.Points[ends[0]], this->Mesh.Points[ends[1]]) /
      (0.5 * (this->Mesh.Sizes[ends[0]] + this->Mesh.Sizes[ends[1]]));
  }

  bool IsThere(const SurfaceEdge& edge) const
  {
    return !this->Mesh.IsDead(edge.Cell) && this->Mesh.Cell(edge.Cell).Version == edge.Version;
  }

  /** The edges of facets whose ratio is in a range, shortest first. */
  std::vector<SurfaceEdge> EdgesWithin(double least, double most) const
  {
    std::vector<SurfaceEdge> edges;
    this->Mesh.VisitFacets(
      [&](Id c, int k)
      {
        const Triangle f = FaceAcross(this->Mesh.Cell(c).Corners, k);
        for (int i = 0; i < 3; ++i)
        {
          const Edge ends = EdgeBetween(f[i], f[(i + 1) % 3]);
          const double ratio = this->RatioOf(ends);
          if (ratio > least && ratio < most)
          {
            edges.push_back({ ratio, ends, c, this->Mesh.Cell(c).Version });
          }
        }
      });
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end(),
                  [](const SurfaceEdge& a, const SurfaceEdge& b) { return a.Ends == b.Ends; }),
      edges.end());
    return edges;
  }

  /** Whether the angles opposite to an edge of the boundary sum to more than 180 degrees. */
  bool IsBadDiagonal(const SurfaceEdge& edge)
  {
    this->Mesh.Ring(edge.Ends[0], edge.Ends[1], edge.Cell, this->Ring);
    if (this->Ring.IsClosed)
    {
      return false;
    }
    double cotangents = 0;
    for (const Id across : { this->Ring.Points.front(), this->Ring.Points.back() })
    {
      cotangents += CotangentAt(this->Mesh.Points[across], this->Mesh.Points[edge.Ends[0]],
        this->Mesh.Points[edge.Ends[1]]);
    }
    return cotangents < 0;
  }

  const double Acceptable = ShapeOfAngle(AcceptableAngle);
  const double AcceptableForLength = ShapeOfAngle(AcceptableAngleForLength);
  SizingField& Sizes;
  EdgeSplitting Splitting{ this->Mesh, this->Surface, this->Bound };
  SurfaceInsertion Insertion{ this->Mesh, this->Surface, this->Bound };
  SurfaceContraction Contract{ this->Mesh, this->Surface, this->Bound };
  Contraction InSolid{ this->Mesh };
  Reconnection Reconnect{ this->Mesh, this->Surface, this->Bound };
  PointSmoothing Smooth{ this->Mesh, this->Surface, this->Bound };
  EdgeRing Ring;
  std::unordered_map<Edge, std::int64_t, HashOfEdge>
    SplitTriedAt; ///< counted in changes of the mesh
};
} // namespace

void TurnDiagonals(RefinableMesh& mesh, RefinableSurface& surface, SurfaceBound& bound,
  SizingField& sizes, Monitor& monitor, const ProgressRange& progress)
{
  SurfaceRemeshing remeshing(mesh, surface, bound, sizes);
  for (int round = 0; round < MostRoundsOfTurns; ++round)
  {
    if (remeshing.TurnDiagonals(monitor, progress) == 0)
    {
      return;
    }
  }
}

void RemeshSurface(RefinableMesh& mesh, RefinableSurface& surface, SurfaceBound& bound,
  SizingField& sizes, Monitor& monitor, const ProgressRange& progress)
{
  if (surface.Treatment() == SurfaceTreatment::Kept)
  {
    return;
  }
  SurfaceRemeshing remeshing(mesh, surface, bound, sizes);
  const bool isRemeshed = surface.Treatment() == SurfaceTreatment::Remeshed;
  const int rounds = isRemeshed ? RoundsWhereRemeshed : RoundsWhereSplit;
  for (int round = 0; round < rounds; ++round)
  {
    const ProgressRange part = { progress.Stage, progress.At(static_cast<double>(round) / rounds),
      progress.At(static_cast<double>(round + 1) / rounds) };
    if (!isRemeshed)
    {
      remeshing.FillFacets(monitor, part);
    }
    else
    {
      if (round == RoundsOfWishes && !sizes.ReplacesSurface())
      {
        const std::vector<SurfacePiece> pieces = PiecesOf(mesh);
        sizes.ShortenAtThinTriangles(pieces, std::vector<double>(pieces.size(), MostHeights), 0);
      }
      remeshing.SplitLongEdges(monitor, part);
      remeshing.ContractShortEdges(monitor, part);
    }
    remeshing.TurnDiagonals(monitor, part);
    remeshing.MovePoints(monitor, part);
    monitor.Check(part.Stage, part.End);
  }
}
} // namespace insideout
