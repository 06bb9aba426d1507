// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/RemeshSurface.h"

#include "Common/LoopProgress.h"
#include "Common/Vectors.h"
#include "Refine/ContractOnSurface.h"
#include "Refine/ReconnectCells.h"
#include "Refine/SmoothPoint.h"
#include "Refine/SplitEdge.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace insideout
{
namespace
{
/** Of the length that edges are to have: between these an edge and its halves are near it. */
constexpr double LongestEdge = 4.0 / 3;
constexpr double ShortestEdge = 4.0 / 5;

/** How long edges may get where others are contracted. */
constexpr double LongestContracted = 1.6;

/** Each splits edges in half, so that there are few; against endless ones. */
constexpr int MostRoundsOfSplits = 60;

/** Of split, contract, turn and move. */
constexpr int RoundsWhereRemeshed = 5;
constexpr int RoundsWhereSplit = 2;

/** An edge of facets, one of its cells, and how long it is, of the length that it is to have. */
struct SurfaceEdge
{
  double Ratio;
  Edge Ends;
  Id Cell;
  Id Version; ///< of the cell: where it is another one by then the edge may be gone

  bool operator<(const SurfaceEdge& other) const
  {
    return this->Ratio != other.Ratio ? this->Ratio < other.Ratio : this->Ends < other.Ends;
  }
};

class SurfaceRemeshing
{
public:
  SurfaceRemeshing(
    RefinableMesh& mesh, RefinableSurface& surface, SurfaceBound& bound, SizingField& sizes)
    : Mesh(mesh)
    , Surface(surface)
    , Sizes(sizes)
    , Splitting(mesh, surface, bound)
    , Contract(mesh, surface, bound)
    , Reconnect(mesh, surface, bound)
    , Smooth(mesh, surface, bound)
  {
  }

  void SplitLongEdges(Monitor& monitor, const ProgressRange& progress)
  {
    for (int round = 0; round < MostRoundsOfSplits; ++round)
    {
      std::vector<SurfaceEdge> edges =
        this->EdgesWithin(LongestEdge, std::numeric_limits<double>::infinity());
      std::reverse(edges.begin(), edges.end());
      std::size_t splits = 0;
      for (const SurfaceEdge& edge : edges)
      {
        if (this->IsThere(edge) && this->Splitting.Find(edge.Ends[0], edge.Ends[1], edge.Cell))
        {
          this->Splitting.Split(this->Sizes);
          ++splits;
        }
      }
      monitor.Check(progress.Stage, progress.At(static_cast<double>(round) / MostRoundsOfSplits));
      if (splits == 0)
      {
        return;
      }
    }
  }

  void ContractShortEdges()
  {
    for (const SurfaceEdge& edge : this->EdgesWithin(0, ShortestEdge))
    {
      if (this->IsThere(edge) &&
        !this->Contract.Contract(edge.Ends[0], edge.Ends[1], 0, LongestContracted))
      {
        this->Contract.Contract(edge.Ends[1], edge.Ends[0], 0, LongestContracted);
      }
    }
  }

  void TurnDiagonals()
  {
    for (const SurfaceEdge& edge : this->EdgesWithin(0, std::numeric_limits<double>::infinity()))
    {
      const auto [u, v] = edge.Ends;
      if (this->IsThere(edge) && !this->Surface.IsRidge(u, v) && this->IsBadDiagonal(edge))
      {
        this->Reconnect.RemoveEdge(u, v, edge.Cell, 0);
      }
    }
  }

  void MovePoints()
  {
    for (Id p = 0; p < static_cast<Id>(this->Mesh.Points.size()); ++p)
    {
      if (this->Mesh.CellAt(p) != None)
      {
        this->Smooth.Relax(p);
      }
    }
  }

private:
  bool IsThere(const SurfaceEdge& edge) const
  {
    return !this->Mesh.IsDead(edge.Cell) && this->Mesh.Version(edge.Cell) == edge.Version;
  }

  /** The edges of facets whose ratio is between two, the shortest first. */
  std::vector<SurfaceEdge> EdgesWithin(double least, double most) const
  {
    std::vector<SurfaceEdge> edges;
    for (Id c = 0; c < this->Mesh.NumberOfCells(); ++c)
    {
      for (int k = 0; k < 4 && !this->Mesh.IsDead(c); ++k)
      {
        if (this->Mesh.Cell(c).Facets[k] == None)
        {
          continue;
        }
        const Triangle f = FaceAcross(this->Mesh.Cell(c).Corners, k);
        for (int i = 0; i < 3; ++i)
        {
          const Edge ends = EdgeBetween(f[i], f[(i + 1) % 3]);
          const double size = 0.5 * (this->Mesh.Sizes[ends[0]] + this->Mesh.Sizes[ends[1]]);
          const double ratio =
            Distance(this->Mesh.Points[ends[0]], this->Mesh.Points[ends[1]]) / size;
          if (ratio > least && ratio < most)
          {
            edges.push_back({ ratio, ends, c, this->Mesh.Version(c) });
          }
        }
      }
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end(),
                  [](const SurfaceEdge& a, const SurfaceEdge& b) { return a.Ends == b.Ends; }),
      edges.end());
    return edges;
  }

  /** Whether the angles across from an edge of the boundary are more than 180 degrees together. */
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
      const Point& apex = this->Mesh.Points[across];
      const Point u = Difference(this->Mesh.Points[edge.Ends[0]], apex);
      const Point v = Difference(this->Mesh.Points[edge.Ends[1]], apex);
      cotangents += Dot(u, v) / Length(Cross(u, v));
    }
    return cotangents < 0;
  }

  RefinableMesh& Mesh;
  RefinableSurface& Surface;
  SizingField& Sizes;
  EdgeSplitting Splitting;
  SurfaceContraction Contract;
  Reconnection Reconnect;
  PointSmoothing Smooth;
  RefinableRing Ring;
};
} // namespace

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
    remeshing.SplitLongEdges(monitor, part);
    if (isRemeshed)
    {
      remeshing.ContractShortEdges();
      monitor.Check(part.Stage, part.End);
    }
    remeshing.TurnDiagonals();
    monitor.Check(part.Stage, part.End);
    remeshing.MovePoints();
    monitor.Check(part.Stage, part.End);
  }
}
} // namespace insideout
