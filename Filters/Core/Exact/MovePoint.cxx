// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/MovePoint.h"

#include "Exact/EngineLimits.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
namespace
{
/** Whether a vertex is one of the corners other than corner k. */
bool HasOther(const Tetrahedron& corners, int k, Id vertex)
{
  return corners[(k + 1) % 4] == vertex || corners[(k + 2) % 4] == vertex ||
    corners[(k + 3) % 4] == vertex;
}
} // namespace

/** The hull stays as it is, and is convex where it is so at each edge. */
bool PointMover::IsHullConvex(Id point, Id apex) const
{
  for (const Id cell : this->Cavity)
  {
    const int infinite = this->Mesh.CornerIndex(cell, this->Mesh.Infinite());
    for (int k = 0; infinite >= 0 && k < 4; ++k)
    {
      Tetrahedron t = this->Mesh.Cell(cell).Corners;
      if (k == infinite)
      {
        continue;
      }
      t[infinite] = this->Mesh.Opposite(cell, k);
      std::replace(t.begin(), t.end(), point, apex);
      if (this->Mesh.Vertices().Orient(t[0], t[1], t[2], t[3]) > 0)
      {
        return false;
      }
    }
  }
  return true;
}

/**
 * Find the cells that give way. Infinite ones stay: they are connected with the vertex as before.
 */
bool PointMover::GrowCavity(Id point, Id apex)
{
  this->Cavity.clear();
  this->Mesh.Star(point, this->Cavity);
  if (!this->IsHullConvex(point, apex))
  {
    return false;
  }
  this->Cavity.erase(std::remove_if(this->Cavity.begin(), this->Cavity.end(),
                       [this](Id cell) { return this->Mesh.IsInfinite(cell); }),
    this->Cavity.end());
  this->Mesh.Marks().Start(this->Mesh.NumberOfCells());
  for (const Id cell : this->Cavity)
  {
    this->Mesh.Marks().Add(cell);
  }
  for (std::size_t next = 0; next < this->Cavity.size(); ++next)
  {
    const FlippableCell& cell = this->Mesh.Cell(this->Cavity[next]);
    for (int k = 0; k < 4; ++k)
    {
      const bool hasPoint = cell.Corners[k] != point && this->Mesh.Has(this->Cavity[next], point);
      if (hasPoint || this->Mesh.Marks().Has(cell.Neighbors[k]))
      {
        continue;
      }
      Tetrahedron t = cell.Corners;
      t[k] = apex;
      if (HasOther(cell.Corners, k, apex) ||
        this->Mesh.Vertices().Orient(t[0], t[1], t[2], t[3]) > 0)
      {
        continue;
      }
      if (cell.Facets[k] != None || this->Mesh.IsInfinite(cell.Neighbors[k]) ||
        this->Cavity.size() == EngineLimits::LargestCavity)
      {
        return false;
      }
      this->Mesh.Marks().Add(cell.Neighbors[k]);
      this->Cavity.push_back(cell.Neighbors[k]);
    }
  }
  return true;
}

/** Make the cells that come, and look whether every vertex, facet and segment stays. */
bool PointMover::KeepsSurface(Id point, Id apex)
{
  this->Fresh.clear();
  this->Wall.Clear();
  this->SurfaceFaces.clear();
  for (const Id id : this->Cavity)
  {
    const FlippableCell& cell = this->Mesh.Cell(id);
    for (int k = 0; k < 4; ++k)
    {
      const bool hasPoint = cell.Corners[k] != point && this->Mesh.Has(id, point);
      if (hasPoint || this->Mesh.Marks().Has(cell.Neighbors[k]))
      {
        continue;
      }
      if (!HasOther(cell.Corners, k, apex))
      {
        this->Fresh.push_back(cell.Corners);
        this->Fresh.back()[k] = apex;
      }
      this->Wall.Add(cell.Corners, k);
    }
  }
  this->Wall.Close();
  for (const Id id : this->Cavity)
  {
    const FlippableCell& cell = this->Mesh.Cell(id);
    if (!this->Wall.Keeps(cell.Corners, point, this->Segments))
    {
      return false;
    }
    for (int k = 0; k < 4; ++k)
    {
      const bool isInner = this->Mesh.Marks().Has(cell.Neighbors[k]);
      const bool isHull = this->Mesh.IsInfinite(cell.Neighbors[k]);
      const int p = this->Mesh.CornerIndex(id, point);
      if (p >= 0 && p != k && (cell.Facets[k] != None || isHull))
      {
        const auto& others = OtherCorners[k][p];
        this->SurfaceFaces.push_back(
          { cell.Corners[others[0]], cell.Corners[others[1]], cell.Facets[k] });
        if (!this->Wall.HasEdge(this->SurfaceFaces.back().A, this->SurfaceFaces.back().B))
        {
          return false;
        }
      }
      else if (isInner && cell.Facets[k] != None)
      {
        return false;
      }
    }
  }
  return true;
}

bool PointMover::Move(Id point, const Point& place)
{
  if (!std::all_of(place.begin(), place.end(), [](double x) { return std::isfinite(x); }))
  {
    return false; // steps and averages of huge coordinates overflow
  }
  const Id marker = this->Mesh.AddVertex(place);
  const bool canMove = this->GrowCavity(point, marker) && this->KeepsSurface(point, point);
  this->Mesh.RemoveLastVertex();
  if (!canMove)
  {
    return false;
  }
  this->Mesh.Replace(this->Cavity, this->Fresh);
  this->Mesh.MoveVertex(point, place);
  for (const SurfaceFace& face : this->SurfaceFaces)
  {
    this->Mesh.MarkFace(point, face.A, face.B, face.Facet);
  }
  return true;
}

bool PointMover::Collapse(Id point, Id neighbor)
{
  if (!this->GrowCavity(point, neighbor) || !this->KeepsSurface(point, neighbor) ||
    !this->SurfaceFaces.empty())
  {
    return false;
  }
  this->Mesh.Replace(this->Cavity, this->Fresh);
  return true;
}
} // namespace insideout
