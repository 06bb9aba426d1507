// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/EdgeRemoval.h"

#include <algorithm>
#include <limits>

namespace insideout
{
namespace
{
/** What a triangulation of a ring leaves in the way of a target. */
struct CostsOfRing
{
  static constexpr int Edge = 0;
  static constexpr int Impossible = std::numeric_limits<int>::max() / 4;

  bool IsBetter(int a, int b) const { return a < b; }
  bool IsEnough(int cost) const { return cost <= this->Most; }
  int Join(int a, int b) const { return a + b; }

  int OfTriangle(int i, int j, int k) const
  {
    const std::vector<Id>& p = this->Ring.Points;
    const bool isPositive = this->Vertices.Orient(p[i], p[j], p[k], this->Ring.V) > 0 &&
      this->Vertices.Orient(p[j], p[i], p[k], this->Ring.U) > 0;
    return isPositive ? this->Target.CostOfFace(p[i], p[j], p[k]) : Impossible;
  }

  int OfDiagonal(int i, int j) const
  {
    const Id p = this->Ring.Points[i];
    const Id q = this->Ring.Points[j];
    const bool isOfRing = i == 0 && static_cast<std::size_t>(j) + 1 == this->Ring.Points.size();
    return isOfRing ? 0
                    : this->Target.CostOfEdge(p, q) + this->Target.CostOfFace(this->Ring.U, p, q) +
        this->Target.CostOfFace(this->Ring.V, p, q);
  }

  const ExactVertices& Vertices;
  const EdgeRing& Ring;
  const FlipTarget& Target;
  int Most;
};
} // namespace

bool FlipOperator::RemoveFace(Id cell, int face, const FlipTarget& target, const Limits& limits)
{
  const FlippableCell& near = this->Mesh.Cell(cell);
  const Id other = near.Neighbors[face];
  if (near.Facets[face] != None || this->Mesh.IsInfinite(cell) || this->Mesh.IsInfinite(other))
  {
    return false;
  }
  const Id p = near.Corners[face];
  const Id q = this->Mesh.Opposite(cell, face);
  const Triangle f = this->Mesh.FaceCorners(cell, face);
  std::vector<Tetrahedron> fresh;
  for (int k = 0; k < 3; ++k)
  {
    if (this->Mesh.Vertices().Orient(q, p, f[k], f[(k + 1) % 3]) <= 0)
    {
      return false;
    }
    fresh.push_back({ { q, p, f[k], f[(k + 1) % 3] } });
  }
  int cost = target.CostOfEdge(p, q) - target.CostOfFace(f[0], f[1], f[2]);
  for (int k = 0; k < 3 && cost <= limits.Increase; ++k)
  {
    cost += target.CostOfFace(p, q, f[k]);
  }
  if (cost > limits.Increase)
  {
    return false;
  }
  this->Mesh.Replace({ cell, other }, fresh);
  return true;
}

bool FlipOperator::IsLocked(const EdgeRing& ring) const
{
  return ring.IsLocked || this->Segments.Find(ring.U, ring.V) != None;
}

/**
 * Around an edge of the hull the ring begins with the infinite vertex here. The edge may go where
 * the two faces of the hull beside it are a flat, strictly convex quadrilateral.
 */
bool FlipOperator::IsHullFlip(const EdgeRing& ring) const
{
  const ExactVertices& vertices = this->Mesh.Vertices();
  const Id p = ring.Points[1];
  const Id q = ring.Points.back();
  if (ring.Points.size() < 4 || vertices.Orient(ring.U, ring.V, p, q) != 0)
  {
    return false;
  }
  const Id inner = ring.Points[2];
  const int side = vertices.Orient(ring.U, p, ring.V, inner);
  return vertices.Orient(ring.U, p, q, inner) == side &&
    vertices.Orient(p, ring.V, q, inner) == side;
}

bool FlipOperator::RemoveEdge(Id u, Id v, Id cell, const FlipTarget& target, const Limits& limits)
{
  EdgeRing& ring = this->Around;
  this->Mesh.Ring(u, v, cell, ring);
  const int n = static_cast<int>(ring.Points.size());
  if (n < 3 || n > limits.LargestRing || u == this->Mesh.Infinite() || v == this->Mesh.Infinite() ||
    this->IsLocked(ring))
  {
    return false;
  }
  const auto infinite =
    std::find(ring.Points.begin(), ring.Points.end(), this->Mesh.Infinite()) - ring.Points.begin();
  const bool onHull = infinite < n;
  if (onHull)
  {
    std::rotate(ring.Points.begin(), ring.Points.begin() + infinite, ring.Points.end());
    std::rotate(ring.Cells.begin(), ring.Cells.begin() + infinite, ring.Cells.end());
    if (!this->IsHullFlip(ring))
    {
      return false;
    }
  }
  CostsOfRing costs = { this->Mesh.Vertices(), ring, target,
    limits.Increase + target.CostOfEdge(u, v) };
  for (const Id p : ring.Points)
  {
    costs.Most += target.CostOfFace(u, v, p);
  }
  const int first = onHull ? 1 : 0;
  if (!this->Triangulation.Find(costs, first, n))
  {
    return false;
  }
  std::vector<Tetrahedron> fresh;
  this->Triangulation.AppendCells(ring, first, n - 1, fresh);
  if (onHull)
  {
    this->Triangulation.AppendPair(ring, 0, 1, n - 1, fresh);
  }
  this->Mesh.Replace(ring.Cells, fresh);
  return true;
}

bool FlipOperator::RemoveEdgeDeeply(
  Id u, Id v, const FlipTarget& target, const Limits& limits, int depth, int& budget)
{
  const Id cell = this->Mesh.FindEdge(u, v);
  if (cell == None || this->RemoveEdge(u, v, cell, target, limits))
  {
    return true;
  }
  if (depth == 0 || budget <= 0 || this->IsLocked(this->Around))
  {
    return false;
  }
  const std::vector<Id> points = this->Around.Points;
  if (points.size() < 4)
  {
    return false;
  }
  for (const Id p : points)
  {
    if (p == this->Mesh.Infinite())
    {
      continue;
    }
    for (const Id end : { u, v })
    {
      if (--budget < 0)
      {
        return false;
      }
      const std::int64_t before = this->Mesh.NumberOfChanges();
      Limits inner = limits;
      inner.Increase = std::max(limits.Increase, 0);
      this->RemoveEdgeDeeply(end, p, target, inner, depth - 1, budget);
      if (this->Mesh.NumberOfChanges() != before)
      {
        const Id now = this->Mesh.FindEdge(u, v);
        if (now == None || this->RemoveEdge(u, v, now, target, limits))
        {
          return true;
        }
      }
    }
  }
  return false;
}
} // namespace insideout
