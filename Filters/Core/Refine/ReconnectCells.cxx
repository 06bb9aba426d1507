// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/ReconnectCells.h"

#include "Common/PointPredicates.h"
#include "Common/Vectors.h"
#include "Refine/CellShape.h"

#include <algorithm>

namespace insideout
{
namespace
{
/**
 * Limit of the ring's length: longer rings have too many triangulations, and hardly any improves
 * the cells.
 */
constexpr int LongestRing = 9;

/** Least relative gain, so that improvement terminates. */
constexpr double LeastGain = 1.0001;

/** The worst shape of the cells of a triangulation of a ring. */
struct ShapesOfRing
{
  static constexpr double Edge = 1;
  static constexpr double Impossible = -1;

  bool IsBetter(double a, double b) const { return a > b; }
  bool IsEnough(double shape) const { return shape > this->Wanted; }
  double Join(double a, double b) const { return std::min(a, b); }
  double OfDiagonal(int /*i*/, int /*j*/) const { return Edge; }

  double OfTriangle(int i, int j, int k) const
  {
    const std::vector<Id>& p = this->Ring.Points;
    const auto shape = [&](int a, int b, Id end) {
      return ShapeOf(this->Points[p[a]], this->Points[p[b]], this->Points[p[k]], this->Points[end]);
    };
    const double above = shape(i, j, this->Ring.V);
    return above <= 0 ? above : std::min(above, shape(j, i, this->Ring.U));
  }

  const std::vector<Point>& Points;
  const EdgeRing& Ring;
  double Wanted;
};
} // namespace

bool Reconnection::ArePositive() const
{
  return std::all_of(this->FreshCells.begin(), this->FreshCells.end(),
    [this](const Tetrahedron& cell) { return Orient3D(this->Mesh.Points, cell) > 0; });
}

/** Whether the faces of a cell that do not contain both ends of the edge lead to cells of its
 * region. If it is the only cell at the edge, it may then be removed without replacement. */
bool Reconnection::HasCellsBehind(Id cell) const
{
  const RefinableCell& here = this->Mesh.Cell(cell);
  for (const Id end : { this->Around.U, this->Around.V })
  {
    const int k = this->Mesh.CornerIndex(cell, end);
    if (here.Neighbors[k] == None || here.Facets[k] != None)
    {
      return false;
    }
  }
  return true;
}

/**
 * Whether the two pieces at an edge of the boundary may be replaced, and by which (FreshPieces).
 */
bool Reconnection::TurnDiagonal()
{
  const EdgeRing& ring = this->Around;
  const Id first = ring.Points.front();
  const Id last = ring.Points.back();
  const auto piece = [this](Id a, Id b, Id c, Id facet)
  {
    const Triangle corners = { { a, b, c } };
    return SurfacePiece{ corners, CornersOf(this->Mesh.Points, corners), facet };
  };
  // Counter-clockwise seen from the cells (U, V, first, second).
  this->GonePieces = { piece(ring.U, ring.V, first, ring.EndFacets[0]),
    piece(ring.V, ring.U, last, ring.EndFacets[1]) };
  this->FreshPieces = { piece(first, last, ring.V, ring.EndFacets[0]),
    piece(last, first, ring.U, ring.EndFacets[0]) };
  if (ring.Cells.size() == 1 && !this->HasCellsBehind(ring.Cells.front()))
  {
    return false;
  }
  if (this->Surface.Treatment() == SurfaceTreatment::Split)
  {
    return ring.EndFacets[0] == ring.EndFacets[1] &&
      this->Bound.Allows(this->GonePieces, this->FreshPieces);
  }
  if (this->Surface.IsPinched(first))
  {
    return false;
  }
  this->Star.clear();
  this->Mesh.Star(first, this->Star);
  const bool isThere = std::any_of(this->Star.begin(), this->Star.end(),
    [&](Id cell)
    {
      const Tetrahedron& corners = this->Mesh.Cell(cell).Corners;
      return std::find(corners.begin(), corners.end(), last) != corners.end();
    });
  return !isThere && this->Bound.Allows(this->GonePieces, this->FreshPieces);
}

bool Reconnection::RemoveEdge(Id u, Id v, Id cell)
{
  this->Mesh.Ring(u, v, cell, this->Around);
  return this->MayRemoveEdge() &&
    this->RemoveEdge(std::max(WorstShapeOf(this->Mesh, this->Around.Cells), 0.0) * LeastGain);
}

bool Reconnection::RemoveEdgeUnlessWorse(Id u, Id v, Id cell, double wanted)
{
  this->Mesh.Ring(u, v, cell, this->Around);
  return this->MayRemoveEdge() &&
    this->RemoveEdge(
      std::min(wanted, std::max(WorstShapeOf(this->Mesh, this->Around.Cells), 0.0) / 2));
}

bool Reconnection::MayRemoveEdge() const
{
  const EdgeRing& ring = this->Around;
  const int n = static_cast<int>(ring.Points.size());
  return !ring.IsLocked && n >= (ring.IsClosed ? 3 : 2) && n <= LongestRing &&
    (ring.IsClosed ||
      (!this->Surface.IsLocked(ring.U, ring.V) && !this->Surface.IsRidge(ring.U, ring.V)));
}

bool Reconnection::RemoveEdge(double wanted)
{
  const EdgeRing& ring = this->Around;
  const int n = static_cast<int>(ring.Points.size());
  if (!this->Triangulation.Find(ShapesOfRing{ this->Mesh.Points, ring, wanted }, 0, n))
  {
    return false;
  }
  this->FreshCells.clear();
  this->Triangulation.AppendCells(ring, 0, n - 1, this->FreshCells);
  if (!this->ArePositive() || (!ring.IsClosed && !this->TurnDiagonal()))
  {
    return false;
  }
  if (ring.IsClosed)
  {
    this->Mesh.Replace(ring.Cells, this->FreshCells);
    return true;
  }
  this->Exchange.Clear();
  this->Exchange.Old = ring.Cells;
  this->Exchange.Fresh = this->FreshCells;
  this->Exchange.Models.assign(this->FreshCells.size(), ring.Cells.front());
  ExchangePieces(this->GonePieces, this->FreshPieces, this->Exchange);
  this->Bound.Replace();
  this->Mesh.Replace(this->Exchange);
  return true;
}

bool Reconnection::RemoveFace(Id cell, int face)
{
  const RefinableCell& near = this->Mesh.Cell(cell);
  if (near.Facets[face] != None)
  {
    return false;
  }
  const Id other = near.Neighbors[face];
  const std::vector<Point>& points = this->Mesh.Points;
  const Id p = near.Corners[face];
  const Id q = this->Mesh.Opposite(cell, face);
  const double wanted = std::max(0.0, WorstShapeOf(this->Mesh, { cell, other })) * LeastGain;
  const Triangle f = FaceAcross(near.Corners, face);
  this->FreshCells.clear();
  for (int k = 0; k < 3; ++k)
  {
    this->FreshCells.push_back({ { q, p, f[k], f[(k + 1) % 3] } });
    if (ShapeOf(points, this->FreshCells.back()) <= wanted)
    {
      return false;
    }
  }
  if (!this->ArePositive())
  {
    return false;
  }
  this->Mesh.Replace({ cell, other }, this->FreshCells);
  return true;
}

bool Reconnection::ImproveCell(Id cell)
{
  const Tetrahedron corners = this->Mesh.Cell(cell).Corners;
  for (int i = 0; i < 4; ++i)
  {
    for (int j = i + 1; j < 4; ++j)
    {
      if (this->RemoveEdge(corners[i], corners[j], cell))
      {
        return true;
      }
    }
  }
  for (int k = 0; k < 4; ++k)
  {
    if (this->RemoveFace(cell, k))
    {
      return true;
    }
  }
  return false;
}
} // namespace insideout
