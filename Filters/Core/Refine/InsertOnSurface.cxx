// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/InsertOnSurface.h"

#include "Common/PointPredicates.h"
#include "Common/SortUniquely.h"
#include "Common/Vectors.h"
#include "Refine/CellShape.h"

#include <algorithm>

namespace insideout
{
namespace
{
/** Limit of steps of a walk in a facet: walks cross a few pieces, and may be cyclic. */
constexpr int MostSteps = 200;

/** Limit of replaced cells: larger cavities belong to places far from the piece to be split. */
constexpr std::size_t LargestCavity = 400;

/** Shape (ShapeOf) of cells between points that rounding put beside one plane. */
constexpr double LeastShape = 1e-14;

/** Whether a place in the plane of a triangle is in its circumcircle. */
bool IsInCircle(const std::array<Point, 3>& t, const Point& place)
{
  const Circumsphere circle = CircumcircleOf(t);
  return !(SquaredDistance(circle.Center, place) >= circle.SquaredRadius);
}

/** Whether a place is right of an edge, in the plane of a normal. */
bool IsBeyond(const Point& from, const Point& to, const Point& place, const Point& normal)
{
  return Dot(Cross(Difference(to, from), Difference(place, from)), normal) < 0;
}
} // namespace

Triangle SurfaceInsertion::CornersOf(const PieceOfCell& piece) const
{
  return FaceAcross(this->Mesh.Cell(piece.Cell).Corners, piece.Face);
}

void SurfaceInsertion::Start(const Point& place)
{
  this->Met = EdgeOfCell();
  this->Halved = { None, None };
  this->Pieces.clear();
  this->Dropped.clear();
  this->Hole.Start(place);
}

/** Add a piece together with the cells on both sides. */
void SurfaceInsertion::AddPiece(const PieceOfCell& piece)
{
  const Triangle key = SortedTriangle(this->CornersOf(piece)).Points;
  if (std::find(this->Dropped.begin(), this->Dropped.end(), key) == this->Dropped.end())
  {
    this->Dropped.push_back(key);
    this->Pieces.push_back(piece);
    this->Hole.Add(piece.Cell);
    if (const Id beyond = this->Mesh.Cell(piece.Cell).Neighbors[piece.Face]; beyond != None)
    {
      this->Hole.Add(beyond);
    }
  }
}

bool SurfaceInsertion::IsDropped(Id cell, int k) const
{
  const Triangle key = SortedTriangle(FaceAcross(this->Mesh.Cell(cell).Corners, k)).Points;
  return std::find(this->Dropped.begin(), this->Dropped.end(), key) != this->Dropped.end();
}

/** The next piece around an edge of a piece, on the side of its cell. */
PieceOfCell SurfaceInsertion::Across(PieceOfCell piece, Id u, Id v) const
{
  for (;;)
  {
    const RefinableCell& here = this->Mesh.Cell(piece.Cell);
    int other = 0;
    while (here.Corners[other] == u || here.Corners[other] == v || other == piece.Face)
    {
      ++other;
    }
    if (here.Facets[other] != None)
    {
      return { piece.Cell, other };
    }
    piece = { here.Neighbors[other], this->Mesh.MirrorIndex(piece.Cell, other) };
  }
}

/** Go to the piece of the same facet that holds a place. */
bool SurfaceInsertion::WalkTo(PieceOfCell& piece, const Point& place)
{
  for (int step = 0; step < MostSteps; ++step)
  {
    const Triangle t = this->CornersOf(piece);
    const std::array<Point, 3> places = insideout::CornersOf(this->Mesh.Points, t);
    const Point normal = NormalOf(places[0], places[1], places[2]);
    int crossed = -1;
    for (int i = 0; i < 3 && crossed < 0; ++i)
    {
      const int k = (i + step) % 3;
      crossed = IsBeyond(places[k], places[(k + 1) % 3], place, normal) ? k : -1;
    }
    if (crossed < 0)
    {
      return true;
    }
    const Edge edge = EdgeBetween(t[crossed], t[(crossed + 1) % 3]);
    if (this->Surface.IsRidge(edge[0], edge[1]))
    {
      this->Met = { edge, piece.Cell };
      return false;
    }
    piece = this->Across(piece, edge[0], edge[1]);
  }
  return false;
}

/** Add the pieces of the same facets whose circumcircle holds the place. */
void SurfaceInsertion::GrowPieces()
{
  for (std::size_t next = 0;
       next < this->Pieces.size() && this->Hole.Cells().size() <= LargestCavity; ++next)
  {
    const PieceOfCell piece = this->Pieces[next];
    const Triangle t = this->CornersOf(piece);
    for (int i = 0; i < 3; ++i)
    {
      const Edge edge = EdgeBetween(t[i], t[(i + 1) % 3]);
      if (edge != this->Halved && !this->Surface.IsRidge(edge[0], edge[1]))
      {
        const PieceOfCell other = this->Across(piece, edge[0], edge[1]);
        if (IsInCircle(
              insideout::CornersOf(this->Mesh.Points, this->CornersOf(other)), this->Hole.Place))
        {
          this->AddPiece(other);
        }
      }
    }
  }
}

/** Keep the pieces whose cells are still marked. @return whether those that hold the place are */
bool SurfaceInsertion::DropPieces()
{
  const auto isLost = [this](const PieceOfCell& piece)
  {
    const Id beyond = this->Mesh.Cell(piece.Cell).Neighbors[piece.Face];
    return !this->Hole.Has(piece.Cell) || (beyond != None && !this->Hole.Has(beyond));
  };
  const auto end = this->Pieces.begin() + static_cast<std::ptrdiff_t>(this->Certain);
  if (std::any_of(this->Pieces.begin(), end, isLost))
  {
    return false;
  }
  this->Pieces.erase(std::remove_if(end, this->Pieces.end(), isLost), this->Pieces.end());
  this->Dropped.clear();
  for (const PieceOfCell& piece : this->Pieces)
  {
    this->Dropped.push_back(SortedTriangle(this->CornersOf(piece)).Points);
  }
  return true;
}

/** The edges that belong to one of the pieces of a facet, except the one that is halved. */
void SurfaceInsertion::CollectRim()
{
  this->Rim.clear();
  for (const PieceOfCell& piece : this->Pieces)
  {
    const Triangle t = this->CornersOf(piece);
    for (int i = 0; i < 3; ++i)
    {
      const Edge edge = EdgeBetween(t[i], t[(i + 1) % 3]);
      const auto isShared = [&](const PieceOfCell& other)
      {
        const Triangle o = this->CornersOf(other);
        return (other.Cell != piece.Cell || other.Face != piece.Face) &&
          this->FacetOf(other) == this->FacetOf(piece) &&
          std::find(o.begin(), o.end(), edge[0]) != o.end() &&
          std::find(o.begin(), o.end(), edge[1]) != o.end();
      };
      if (edge != this->Halved && std::none_of(this->Pieces.begin(), this->Pieces.end(), isShared))
      {
        this->Rim.push_back({ t[i], t[(i + 1) % 3], piece });
      }
    }
  }
}

/**
 * Whether walls and rim close the space around the place, and contain all points of the old cells.
 */
bool SurfaceInsertion::FitsTogether() const
{
  std::vector<Edge> edges;
  for (const Triangle& wall : this->Hole.Walls)
  {
    for (int i = 0; i < 3; ++i)
    {
      edges.push_back(EdgeBetween(wall[i], wall[(i + 1) % 3]));
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<Edge> onBoundary;
  for (const RimEdge& rim : this->Rim)
  {
    const Edge edge = EdgeBetween(rim.From, rim.To);
    const std::array<Point, 3> t = { { this->Mesh.Points[rim.From], this->Mesh.Points[rim.To],
      this->Hole.Place } };
    const auto before = insideout::CornersOf(this->Mesh.Points, this->CornersOf(rim.Piece));
    if (!std::binary_search(edges.begin(), edges.end(), edge) ||
      !AreUnfolded({ { {}, t, None } }, NormalOf(before[0], before[1], before[2])))
    {
      return false;
    }
    if (this->Mesh.Cell(rim.Piece.Cell).Neighbors[rim.Piece.Face] == None)
    {
      onBoundary.push_back(edge);
    }
  }
  SortUniquely(onBoundary);
  for (auto first = edges.begin(); first != edges.end();)
  {
    const auto last = std::find_if(first, edges.end(), [&](const Edge& e) { return e != *first; });
    const bool isRim = std::binary_search(onBoundary.begin(), onBoundary.end(), *first);
    if (last - first != (isRim ? 1 : 2))
    {
      return false;
    }
    first = last;
  }
  return this->Hole.KeepsItsPoints();
}

/** Whether the pieces between the rim and the place cross no others. */
bool SurfaceInsertion::StaysApart()
{
  std::vector<SurfacePiece> gone;
  std::vector<SurfacePiece> fresh;
  for (const PieceOfCell& piece : this->Pieces)
  {
    const Triangle corners = this->CornersOf(piece);
    gone.push_back(
      { corners, insideout::CornersOf(this->Mesh.Points, corners), this->FacetOf(piece) });
  }
  for (const RimEdge& rim : this->Rim)
  {
    fresh.push_back({ { { rim.From, rim.To, this->Mesh.NextPoint() } },
      { { this->Mesh.Points[rim.From], this->Mesh.Points[rim.To], this->Hole.Place } },
      this->FacetOf(rim.Piece) });
  }
  return this->Bound.AllowsCut(gone, fresh);
}

/** Given the certain pieces and cells: the rest, trimmed so that the place sees all walls. */
bool SurfaceInsertion::Complete()
{
  this->Certain = this->Pieces.size();
  std::vector<Id> seeds;
  for (const PieceOfCell& piece : this->Pieces)
  {
    seeds.push_back(piece.Cell);
    seeds.push_back(this->Mesh.Cell(piece.Cell).Neighbors[piece.Face]);
  }
  if (this->Surface.Treatment() == SurfaceTreatment::Split)
  {
    this->GrowPieces();
  }
  const std::vector<Point>& points = this->Mesh.Points;
  const auto isOpen = [this](Id cell, int k) { return this->IsDropped(cell, k); };
  const auto isSeen = [&](const Triangle& f)
  {
    return Orient3D(points[f[0]], points[f[1]], points[f[2]], this->Hole.Place) > 0 &&
      ShapeOf(points[f[0]], points[f[1]], points[f[2]], this->Hole.Place) > LeastShape;
  };
  this->Hole.Grow(LargestCavity);
  while (this->Hole.CollectWalls(isOpen, isSeen))
  {
    if (!this->DropPieces())
    {
      return false;
    }
    this->Hole.KeepConnected(seeds, isOpen);
    if (!this->DropPieces())
    {
      return false;
    }
  }
  this->CollectRim();
  return this->FitsTogether();
}

bool SurfaceInsertion::FindOnEdge(const EdgeOfCell& edge)
{
  const auto [u, v] = edge.Ends;
  EdgeRing ring;
  this->Mesh.Ring(u, v, edge.Cell, ring);
  if (!ring.IsOnFacet() || this->Surface.IsLocked(u, v))
  {
    return false;
  }
  this->Start(Midpoint(this->Mesh.Points[u], this->Mesh.Points[v]));
  this->Halved = EdgeBetween(u, v);
  for (const Id cell : ring.Cells)
  {
    this->Hole.Add(cell);
    const RefinableCell& here = this->Mesh.Cell(cell);
    for (int k = 0; k < 4; ++k)
    {
      if (here.Facets[k] != None && here.Corners[k] != u && here.Corners[k] != v)
      {
        this->AddPiece({ cell, k });
      }
    }
  }
  return this->Complete();
}

bool SurfaceInsertion::FindOnFacet(PieceOfCell piece, const Point& place)
{
  // The center of the circle is, up to rounding, near or beyond a locked ridge.
  this->Met = EdgeOfCell();
  if (this->Surface.IsLocked(this->FacetOf(piece)))
  {
    return false;
  }
  const std::array<Point, 3>& t = this->Surface.Facet(this->FacetOf(piece)).Corners;
  const Point normal = NormalOf(t[0], t[1], t[2]);
  const double height = Dot(Difference(place, t[0]), normal) / Dot(normal, normal);
  this->Start({ { place[0] - height * normal[0], place[1] - height * normal[1],
    place[2] - height * normal[2] } });
  if (!IsFinite(this->Hole.Place) || !this->WalkTo(piece, this->Hole.Place))
  {
    return false;
  }
  this->AddPiece(piece);
  return this->Complete();
}

EdgeOfCell SurfaceInsertion::Encroached() const
{
  for (const RimEdge& rim : this->Rim)
  {
    const Point& a = this->Mesh.Points[rim.From];
    const Point& b = this->Mesh.Points[rim.To];
    if (this->Surface.IsRidge(rim.From, rim.To) &&
      Dot(Difference(a, this->Hole.Place), Difference(b, this->Hole.Place)) < 0)
    {
      return { EdgeBetween(rim.From, rim.To), rim.Piece.Cell };
    }
  }
  return EdgeOfCell();
}

bool SurfaceInsertion::Insert(SizingField& sizes)
{
  if (!this->StaysApart())
  {
    return false;
  }
  const bool isOnRidge =
    this->Halved[0] != None && this->Surface.IsRidge(this->Halved[0], this->Halved[1]);
  const double size = this->SizeThere(sizes);
  sizes.Append(this->Hole.Cells().front(), this->Hole.Place);
  const Id point = this->Mesh.AddPoint(
    this->Hole.Place, isOnRidge ? PointKind::OnRidge : PointKind::InFacet, size);
  CellExchange exchange;
  exchange.Old = this->Hole.Cells();
  exchange.Gone = this->Dropped;
  for (std::size_t w = 0; w < this->Hole.Walls.size(); ++w)
  {
    const Triangle& wall = this->Hole.Walls[w];
    exchange.Add({ { wall[0], wall[1], wall[2], point } }, this->Hole.CellsOfWalls[w]);
  }
  for (const RimEdge& rim : this->Rim)
  {
    exchange.Facets.push_back({ { { rim.From, rim.To, point } }, this->FacetOf(rim.Piece) });
  }
  this->Bound.Replace();
  this->Mesh.Replace(exchange);
  if (isOnRidge)
  {
    this->Surface.Split(this->Halved[0], this->Halved[1], point);
  }
  return true;
}
} // namespace insideout
