// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/ReconnectCells.h"

#include "Common/PointPredicates.h"
#include "Refine/CellShape.h"

#include <algorithm>

namespace insideout
{
namespace
{
/** All triangulations of longer rings take long, and hardly one of them is better. */
constexpr int LongestRing = 9;

/** What gets better by less is left, so that changes come to an end. */
constexpr double LeastGain = 1.0001;

constexpr double Impossible = -1;
} // namespace

double Reconnection::ShapeOfTriangle(int i, int j, int k) const
{
  const std::vector<Id>& p = this->Around.Points;
  const std::vector<Point>& points = this->Mesh.Points;
  const double above = ShapeOf(points[p[i]], points[p[j]], points[p[k]], points[this->Around.V]);
  return above <= 0
    ? above
    : std::min(above, ShapeOf(points[p[j]], points[p[i]], points[p[k]], points[this->Around.U]));
}

void Reconnection::CollectTriangles(int i, int j)
{
  if (j == i + 1)
  {
    return;
  }
  const std::vector<Id>& p = this->Around.Points;
  const int k = this->Middle[i * static_cast<int>(p.size()) + j];
  this->FreshCells.push_back({ { p[i], p[k], p[j], this->Around.V } });
  this->FreshCells.push_back({ { p[k], p[i], p[j], this->Around.U } });
  this->CollectTriangles(i, k);
  this->CollectTriangles(k, j);
}

bool Reconnection::ArePositive() const
{
  return std::all_of(this->FreshCells.begin(), this->FreshCells.end(),
    [this](const Tetrahedron& cell) { return Orient3D(this->Mesh.Points, cell) > 0; });
}

bool Reconnection::RemoveEdge(Id u, Id v, Id cell)
{
  this->Mesh.Ring(u, v, cell, this->Around);
  const RefinableRing& ring = this->Around;
  const int n = static_cast<int>(ring.Points.size());
  if (!ring.IsClosed || ring.IsLocked || n > LongestRing || n < 3)
  {
    return false;
  }
  double before = 1;
  for (const Id c : ring.Cells)
  {
    before = std::min(before, ShapeOf(this->Mesh.Points, this->Mesh.Cell(c).Corners));
  }
  const double wanted = std::max(before, 0.0) * LeastGain;
  this->Best.assign(static_cast<std::size_t>(n) * n, Impossible);
  this->Middle.assign(static_cast<std::size_t>(n) * n, -1);
  for (int i = 0; i + 1 < n; ++i)
  {
    this->Best[i * n + i + 1] = 1;
  }
  for (int length = 2; length < n; ++length)
  {
    for (int i = 0; i + length < n; ++i)
    {
      const int j = i + length;
      double& best = this->Best[i * n + j];
      for (int k = i + 1; k < j; ++k)
      {
        const double parts = std::min(this->Best[i * n + k], this->Best[k * n + j]);
        if (parts > wanted && parts > best)
        {
          const double shape = std::min(parts, this->ShapeOfTriangle(i, k, j));
          if (shape > best)
          {
            best = shape;
            this->Middle[i * n + j] = k;
          }
        }
      }
    }
  }
  if (this->Best[n - 1] <= wanted)
  {
    return false;
  }
  this->FreshCells.clear();
  this->CollectTriangles(0, n - 1);
  if (!this->ArePositive())
  {
    return false;
  }
  this->Mesh.Replace(ring.Cells, this->FreshCells);
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
  const Id q = this->Mesh.Cell(other).Corners[this->Mesh.MirrorIndex(cell, face)];
  const double wanted =
    std::max(0.0,
      std::min(ShapeOf(points, near.Corners), ShapeOf(points, this->Mesh.Cell(other).Corners))) *
    LeastGain;
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
