// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/SplitEdge.h"

#include "Common/PointPredicates.h"
#include "Common/Vectors.h"
#include "Refine/EdgeLengths.h"

#include <algorithm>

namespace insideout
{
namespace
{
/** A cell or triangle with one point replaced by another. */
template <class Corners>
Corners With(Corners corners, Id point, Id instead)
{
  std::replace(corners.begin(), corners.end(), instead, point);
  return corners;
}
} // namespace

/**
 * Half of a piece has half its height above the longer edge. If only the other edges were split
 * repeatedly, pieces would become ever flatter.
 */
bool EdgeSplitting::IsBesideLonger() const
{
  const std::vector<Point>& points = this->Mesh.Points;
  const double most = MostTimesLonger * Distance(points[this->Ring.U], points[this->Ring.V]);
  for (const Id c : this->Ring.Cells)
  {
    const RefinableCell& cell = this->Mesh.Cell(c);
    for (int k = 0; k < 4; ++k)
    {
      if (cell.Facets[k] != None && cell.Corners[k] != this->Ring.U &&
        cell.Corners[k] != this->Ring.V)
      {
        if (LongestEdgeOf(CornersOf(points, FaceAcross(cell.Corners, k))) > most)
        {
          return true;
        }
      }
    }
  }
  return false;
}

bool EdgeSplitting::Find(Id u, Id v, Id cell)
{
  this->Mesh.Ring(u, v, cell, this->Ring);
  if (this->Ring.IsOnFacet() && (this->Surface.IsLocked(u, v) || this->IsBesideLonger()))
  {
    return false;
  }
  const std::vector<Point>& points = this->Mesh.Points;
  this->Middle = Midpoint(points[u], points[v]);
  const bool isPositive = std::all_of(this->Ring.Cells.begin(), this->Ring.Cells.end(),
    [&](Id c)
    {
      const Tetrahedron& corners = this->Mesh.Cell(c).Corners;
      std::array<Point, 4> first;
      std::array<Point, 4> second;
      for (int k = 0; k < 4; ++k)
      {
        first[k] = corners[k] == v ? this->Middle : points[corners[k]];
        second[k] = corners[k] == u ? this->Middle : points[corners[k]];
      }
      return Orient3D(first[0], first[1], first[2], first[3]) > 0 &&
        Orient3D(second[0], second[1], second[2], second[3]) > 0;
    });
  return isPositive && this->StaysApart();
}

/** Whether the halves of the pieces at the edge cross no others. */
bool EdgeSplitting::StaysApart()
{
  this->Gone.clear();
  this->Halves.clear();
  const Id middle = this->Mesh.NextPoint();
  for (const Id c : this->Ring.Cells)
  {
    const RefinableCell& cell = this->Mesh.Cell(c);
    for (int k = 0; k < 4; ++k)
    {
      const bool isAtEdge = cell.Corners[k] != this->Ring.U && cell.Corners[k] != this->Ring.V;
      if (isAtEdge && this->Mesh.HasPiece(c, k))
      {
        this->Gone.push_back(PieceAt(this->Mesh, c, k));
        for (const Id end : { this->Ring.V, this->Ring.U })
        {
          this->Halves.push_back(this->Gone.back());
          auto& [corners, places, facet] = this->Halves.back();
          const auto at = std::find(corners.begin(), corners.end(), end) - corners.begin();
          corners[at] = middle;
          places[at] = this->Middle;
        }
      }
    }
  }
  return this->Bound.AllowsCut(this->Gone, this->Halves);
}

Id EdgeSplitting::Split(SizingField& sizes)
{
  const auto [u, v] = std::pair(this->Ring.U, this->Ring.V);
  const PointKind kind = !this->Ring.IsOnFacet() ? PointKind::Free
    : this->Surface.IsRidge(u, v)                ? PointKind::OnRidge
                                                 : PointKind::InFacet;
  const double size = sizes.At(this->Ring.Cells.front(), this->Middle);
  sizes.Append(this->Ring.Cells.front(), this->Middle);
  const Id middle = this->Mesh.AddPoint(this->Middle, kind, size);
  CellExchange exchange;
  exchange.Old = this->Ring.Cells;
  for (const Id c : this->Ring.Cells)
  {
    const RefinableCell& cell = this->Mesh.Cell(c);
    exchange.Add(With(cell.Corners, middle, v), c);
    exchange.Add(With(cell.Corners, middle, u), c);
  }
  ExchangePieces(this->Gone, this->Halves, exchange);
  this->Bound.Replace();
  this->Mesh.Replace(exchange);
  this->Surface.Split(u, v, middle);
  return middle;
}
} // namespace insideout
