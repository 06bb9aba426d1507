// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/RemeshPieces.h"

#include "Common/LoopProgress.h"
#include "Common/SortUniquely.h"
#include "Common/Vectors.h"
#include "Refine/EdgeLengths.h"
#include "Refine/SurfaceMesh.h"

#include <algorithm>
#include <limits>
#include <unordered_map>

namespace insideout
{
namespace
{
/** Pieces of a lower height (LowestOf) are not made from higher ones. */
constexpr double LeastHeight = 0.2;

/** As MostHeights, where no lengths are wanted. */
constexpr double MostHeightsOfSurface = 2.4;

/**
 * As MostHeights, where lengths are wanted, on narrow sides between ridges, whose triangles are
 * thin if edges are as long as wanted.
 */
constexpr double MostHeightsBetweenRidges = 20;

/** Relative to the tolerance: lengths are not reduced further. The middle of such an edge is one
 * tolerance away from an arc whose radius is three. */
constexpr double LeastLength = 5;

/** Relative to the tolerance, for corners where no length is wanted: thin bodies lose volume there.
 */
constexpr double ShareForCorners = 0.5;

bool Has(const Triangle& corners, Id point)
{
  return std::find(corners.begin(), corners.end(), point) != corners.end();
}

/** A piece with one corner replaced by another. */
SurfacePiece With(SurfacePiece piece, Id corner, Id other, const Point& place)
{
  for (int k = 0; k < 3; ++k)
  {
    if (piece.Corners[k] == corner)
    {
      piece.Corners[k] = other;
      piece.Places[k] = place;
    }
  }
  return piece;
}

/** The other points of pieces at a point, and the edges opposite to it. */
struct Link
{
  std::vector<Id> Points;
  std::vector<Edge> Edges;
};

class PieceRemeshing : public SurfaceOperator
{
public:
  PieceRemeshing(
    RefinableMesh& mesh, RefinableSurface& surface, SurfaceBound& bound, SizingField& sizes)
    : SurfaceOperator(mesh, surface, bound)
    , Sizes(sizes)
    , Pieces(PiecesOf(mesh))
  {
  }

  const SurfaceMesh& Result() const { return this->Pieces; }

  /** Reduce the sizes where pieces are thin: edges beside them have to stay short. */
  void ShortenAtThinTriangles(double least)
  {
    const std::vector<SurfacePiece> pieces = this->Pieces.All();
    std::vector<double> heights;
    for (const SurfacePiece& piece : pieces)
    {
      heights.push_back(!this->Sizes.ReplacesSurface() ? MostHeightsOfSurface
          : this->IsBetweenRidges(piece)               ? MostHeightsBetweenRidges
                                                       : MostHeights);
    }
    this->Sizes.ShortenAtThinTriangles(pieces, heights, least);
  }

  void SplitLongEdges(Monitor& monitor, const ProgressRange& progress)
  {
    for (int round = 0; round < MostRoundsOfSplits; ++round)
    {
      std::vector<SizedEdge> edges =
        this->EdgesWithin(LongestEdge, std::numeric_limits<double>::infinity());
      std::reverse(edges.begin(), edges.end());
      std::size_t splits = 0;
      const LoopProgress looked(monitor, progress, edges.size());
      for (std::size_t i = 0; i < edges.size(); ++i)
      {
        looked.Check(i);
        splits += this->IsThere(edges[i]) && this->Split(edges[i].Ends) ? 1 : 0;
      }
      if (splits == 0)
      {
        return;
      }
    }
  }

  void ContractShortEdges(Monitor& monitor, const ProgressRange& progress)
  {
    const std::vector<SizedEdge> edges = this->EdgesWithin(0, ShortestEdge);
    const LoopProgress looked(monitor, progress, edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i)
    {
      looked.Check(i);
      const auto [u, v] = edges[i].Ends;
      if (this->IsThere(edges[i]) && this->HasChanged(edges[i].Ends) && !this->Contract(u, v) &&
        !this->Contract(v, u) && !this->ContractCorner(u, v))
      {
        this->ContractCorner(v, u);
      }
    }
  }

  /** Flip edges that are no Delaunay edges. */
  void TurnDiagonals(Monitor& monitor, const ProgressRange& progress)
  {
    const std::vector<SizedEdge> edges =
      this->EdgesWithin(0, std::numeric_limits<double>::infinity());
    const LoopProgress looked(monitor, progress, edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i)
    {
      looked.Check(i);
      if (this->IsThere(edges[i]))
      {
        this->Turn(edges[i].Ends);
      }
    }
  }

  void MovePoints(Monitor& monitor, const ProgressRange& progress)
  {
    const LoopProgress looked(monitor, progress, this->Mesh.Points.size());
    for (Id p = 0; p < static_cast<Id>(this->Mesh.Points.size()); ++p)
    {
      looked.Check(static_cast<std::size_t>(p));
      this->Move(p);
    }
  }

private:
  /** An edge, and its length relative to the required one. */
  struct SizedEdge
  {
    double Ratio;
    Edge Ends;

    bool operator<(const SizedEdge& other) const
    {
      return this->Ratio != other.Ratio ? this->Ratio < other.Ratio : this->Ends < other.Ends;
    }
  };

  /** Whether a piece is narrow because a ridge is opposite to a ridge. */
  bool IsBetweenRidges(const SurfacePiece& piece) const
  {
    for (int i = 0; i < 3; ++i)
    {
      if (this->Surface.IsRidge(piece.Corners[i], piece.Corners[(i + 1) % 3]) &&
        this->Mesh.Kinds[piece.Corners[(i + 2) % 3]] != PointKind::InFacet)
      {
        return true;
      }
    }
    return false;
  }

  double RatioOf(const Edge& ends) const
  {
    return Distance(this->Mesh.Points[ends[0]], this->Mesh.Points[ends[1]]) /
      (0.5 * (this->Mesh.Sizes[ends[0]] + this->Mesh.Sizes[ends[1]]));
  }

  /** Whether an edge is there, as long as it was. */
  bool IsThere(const SizedEdge& edge) const
  {
    return this->RatioOf(edge.Ends) == edge.Ratio &&
      !this->Pieces.AtEdge(edge.Ends[0], edge.Ends[1]).empty();
  }

  /** Those whose ratio is in a range, shortest first. */
  std::vector<SizedEdge> EdgesWithin(double least, double most) const
  {
    std::vector<SizedEdge> edges;
    for (const Edge& ends : this->Pieces.Edges())
    {
      const double ratio = this->RatioOf(ends);
      if (ratio > least && ratio < most)
      {
        edges.push_back({ ratio, ends });
      }
    }
    std::sort(edges.begin(), edges.end());
    return edges;
  }

  /** Whether pieces at the ends have changed since the last call: otherwise the result is the same,
   * for sizes never grow. */
  bool HasChanged(const Edge& ends)
  {
    const auto [tried, isNew] = this->TriedAt.emplace(ends, 0);
    const bool hasChanged = isNew ||
      std::max(this->Pieces.LastChangeAt(ends[0]), this->Pieces.LastChangeAt(ends[1])) >
        tried->second;
    tried->second = this->Pieces.NumberOfChanges();
    return hasChanged;
  }

  void Take(const std::vector<Id>& pieces)
  {
    this->Old = pieces;
    this->Gone.clear();
    for (const Id piece : pieces)
    {
      this->Gone.push_back(this->Pieces.Piece(piece));
    }
    this->Fresh.clear();
  }

  /** Whether a step makes low pieces from higher ones. */
  bool GetsLower() const
  {
    return LowestOf(this->Fresh) < std::min(LeastHeight, LowestOf(this->Gone));
  }

  void Replace()
  {
    this->Bound.Replace();
    this->Pieces.Replace(this->Old, this->Fresh);
  }

  bool Split(const Edge& ends)
  {
    const auto [u, v] = ends;
    if (this->Surface.IsLocked(u, v))
    {
      return false;
    }
    this->Take(this->Pieces.AtEdge(u, v));
    const double most = MostTimesLonger * Distance(this->Mesh.Points[u], this->Mesh.Points[v]);
    if (std::any_of(this->Gone.begin(), this->Gone.end(),
          [&](const SurfacePiece& piece) { return LongestEdgeOf(piece.Places) > most; }))
    {
      return false;
    }
    const Point place = Midpoint(this->Mesh.Points[u], this->Mesh.Points[v]);
    const Id middle = this->Mesh.NextPoint();
    for (const SurfacePiece& piece : this->Gone)
    {
      this->Fresh.push_back(With(piece, v, middle, place));
      this->Fresh.push_back(With(piece, u, middle, place));
    }
    if (!this->Bound.AllowsCut(this->Gone, this->Fresh))
    {
      return false;
    }
    const double size = this->Sizes.AppendBetween(u, v, place);
    this->Mesh.AddPoint(
      place, this->Surface.IsRidge(u, v) ? PointKind::OnRidge : PointKind::InFacet, size);
    this->Surface.Split(u, v, middle);
    this->Replace();
    return true;
  }

  Link LinkOf(Id point) const
  {
    Link link;
    for (const Id id : this->Pieces.At(point))
    {
      const Triangle& corners = this->Pieces.Piece(id).Corners;
      const int at = corners[0] == point ? 0 : corners[1] == point ? 1 : 2;
      const Edge across = EdgeBetween(corners[(at + 1) % 3], corners[(at + 2) % 3]);
      link.Edges.push_back(across);
      link.Points.insert(link.Points.end(), across.begin(), across.end());
    }
    SortUniquely(link.Points);
    SortUniquely(link.Edges);
    return link;
  }

  /** Contract a point into a neighbor, if the surface keeps its ridges. */
  bool Contract(Id point, Id target)
  {
    if (!this->Surface.MayContract(point, target) || !this->TakeContracted(point, target))
    {
      return false;
    }
    const bool isAllowed = this->Surface.IsRidge(point, target)
      ? this->Bound.AllowsEach(this->Moved, this->Gone, this->Fresh)
      : !this->GetsLower() && this->Bound.Allows(this->Gone, this->Fresh);
    if (isAllowed)
    {
      this->Surface.Contract(point, target);
      this->Replace();
    }
    return isAllowed;
  }

  /** Contract a point of ridges that need not follow one of them, with all of them: where they are
   * finer than the tolerance. */
  bool ContractCorner(Id point, Id target)
  {
    if (this->Mesh.Kinds[point] == PointKind::InFacet || !this->Surface.MayLeave(point) ||
      this->Surface.IsPinched(target) || !this->TakeContracted(point, target) ||
      !this->KeepsLabels(this->Gone, this->Moved) || this->GetsLower() ||
      !this->Bound.AllowsEach(
        this->Moved, this->Gone, this->Fresh, this->Sizes.ReplacesSurface() ? 1 : ShareForCorners))
    {
      return false;
    }
    this->Surface.Contract(point, target);
    this->Mesh.Kinds[target] = PointKind::Fixed;
    this->Replace();
    return true;
  }

  /** Take the pieces that a contraction changes. @return whether the surface keeps its topology
   * (the link conditions of Dey et al. 1999), and no edge gets too long */
  bool TakeContracted(Id point, Id target)
  {
    const Link ofPoint = this->LinkOf(point);
    const Link ofTarget = this->LinkOf(target);
    std::vector<Id> ofEdge;
    for (const Id id : this->Pieces.AtEdge(point, target))
    {
      for (const Id corner : this->Pieces.Piece(id).Corners)
      {
        if (corner != point && corner != target)
        {
          ofEdge.push_back(corner);
        }
      }
    }
    SortUniquely(ofEdge);
    const Point& place = this->Mesh.Points[target];
    const bool isLong = std::any_of(ofPoint.Points.begin(), ofPoint.Points.end(),
      [&](Id other)
      {
        return Distance(this->Mesh.Points[other], place) >
          LongestContracted * 0.5 * (this->Mesh.Sizes[other] + this->Mesh.Sizes[target]);
      });
    if (isLong || InBoth(ofPoint.Points, ofTarget.Points) != ofEdge ||
      !InBoth(ofPoint.Edges, ofTarget.Edges).empty())
    {
      return false;
    }
    this->Take(this->Pieces.At(point));
    this->Moved.clear();
    for (const SurfacePiece& piece : this->Gone)
    {
      if (!Has(piece.Corners, target))
      {
        this->Moved.push_back(piece);
        this->Fresh.push_back(With(piece, point, target, place));
      }
    }
    return true;
  }

  bool Turn(const Edge& ends)
  {
    const Id u = ends[0];
    const Id v = ends[1];
    if (this->Surface.IsRidge(u, v))
    {
      return false;
    }
    this->Take(this->Pieces.AtEdge(u, v));
    if (this->Gone.size() != 2)
    {
      return false;
    }
    std::array<Id, 2> across;
    double cotangents = 0;
    for (int i = 0; i < 2; ++i)
    {
      const Triangle& corners = this->Gone[i].Corners;
      across[i] = *std::find_if(
        corners.begin(), corners.end(), [&](Id corner) { return corner != u && corner != v; });
      cotangents +=
        CotangentAt(this->Mesh.Points[across[i]], this->Mesh.Points[u], this->Mesh.Points[v]);
    }
    if (!(cotangents < 0) || this->Surface.IsPinched(across[0]) ||
      !this->Pieces.AtEdge(across[0], across[1]).empty())
    {
      return false;
    }
    this->Fresh = { With(this->Gone[0], u, across[1], this->Mesh.Points[across[1]]),
      With(this->Gone[0], v, across[1], this->Mesh.Points[across[1]]) };
    if (!this->Bound.Allows(this->Gone, this->Fresh))
    {
      return false;
    }
    this->Replace();
    return true;
  }

  /** Move a point in a facet to the center of the pieces around it. */
  bool Move(Id point)
  {
    if (this->Mesh.Kinds[point] != PointKind::InFacet || this->Pieces.At(point).empty())
    {
      return false;
    }
    this->Take(this->Pieces.At(point));
    Point center;
    if (!FindCenter(this->Gone, center))
    {
      return false;
    }
    const Point place = this->Bound.PlaceOn(center, this->Gone.front().Facet);
    if (!(Distance(place, this->Mesh.Points[point]) > LeastMove * this->Mesh.Sizes[point]))
    {
      return false;
    }
    for (const SurfacePiece& piece : this->Gone)
    {
      this->Fresh.push_back(With(piece, point, point, place));
    }
    if (this->GetsLower() || !this->Bound.Allows(this->Gone, this->Fresh))
    {
      return false;
    }
    this->Mesh.Points[point] = place;
    this->Replace();
    return true;
  }

  SizingField& Sizes;
  SurfaceMesh Pieces;
  std::vector<Id> Old; ///< the pieces of a step
  std::vector<SurfacePiece> Gone;
  std::vector<SurfacePiece> Moved; ///< by a contraction: each becomes a fresh one
  std::vector<SurfacePiece> Fresh;
  std::unordered_map<Edge, std::int64_t, HashOfEdge> TriedAt; ///< counted in changes
};
} // namespace

std::vector<SurfacePiece> RemeshPieces(RefinableMesh& mesh, RefinableSurface& surface,
  SurfaceBound& bound, SizingField& sizes, double tolerance, Monitor& monitor,
  const ProgressRange& progress)
{
  PieceRemeshing remeshing(mesh, surface, bound, sizes);
  for (int round = 0; round < RoundsWhereRemeshed; ++round)
  {
    // Where lengths are wanted, they are reduced once only.
    if (round == RoundsOfWishes || (round > RoundsOfWishes && !sizes.ReplacesSurface()))
    {
      remeshing.ShortenAtThinTriangles(LeastLength * tolerance);
    }
    const double part = progress.At(static_cast<double>(round) / RoundsWhereRemeshed);
    const ProgressRange now = { progress.Stage, part, part };
    remeshing.SplitLongEdges(monitor, now);
    remeshing.ContractShortEdges(monitor, now);
    remeshing.TurnDiagonals(monitor, now);
    remeshing.MovePoints(monitor, now);
  }
  return remeshing.Result().All();
}
} // namespace insideout
