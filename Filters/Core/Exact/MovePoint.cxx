// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/MovePoint.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
namespace
{
/** Limit of cells replaced when a point moves: nearly all moves replace fewer. */
constexpr std::size_t LargestCavity = 400;

/** Whether the hull, which keeps its shape, is convex at each edge. */
bool IsHullConvex(const FlippableMesh& mesh, const std::vector<Id>& star, Id point, Id apex)
{
  for (const Id cell : star)
  {
    const int infinite = mesh.CornerIndex(cell, mesh.Infinite());
    for (int k = 0; infinite >= 0 && k < 4; ++k)
    {
      Tetrahedron t = mesh.Cell(cell).Corners;
      if (k == infinite)
      {
        continue;
      }
      t[infinite] = mesh.Opposite(cell, k);
      std::replace(t.begin(), t.end(), point, apex);
      if (mesh.Vertices().Orient(t[0], t[1], t[2], t[3]) > 0)
      {
        return false;
      }
    }
  }
  return true;
}

/** Find the cells to replace. Infinite ones stay: they remain connected with the vertex. */
bool Grow(const FlippableMesh& mesh, const std::vector<Id>& star, Cone& cone, Id point, Id apex)
{
  if (!IsHullConvex(mesh, star, point, apex))
  {
    return false;
  }
  cone.Old.Clear();
  for (const Id cell : star)
  {
    if (!mesh.IsInfinite(cell))
    {
      cone.Old.Add(cell);
    }
  }
  for (std::size_t next = 0; next < cone.Old.Members().size(); ++next)
  {
    const FlippableCell& cell = mesh.Cell(cone.Old.Members()[next]);
    const int atPoint = CornerIndexIn(cell.Corners, point);
    const int atApex = CornerIndexIn(cell.Corners, apex);
    for (int k = 0; k < 4; ++k)
    {
      if ((atPoint >= 0 && atPoint != k) || (atApex >= 0 && atApex != k) ||
        cone.Old.Has(cell.Neighbors[k]))
      {
        continue;
      }
      Tetrahedron t = cell.Corners;
      t[k] = apex;
      if (mesh.Vertices().Orient(t[0], t[1], t[2], t[3]) > 0)
      {
        continue;
      }
      if (cell.Facets[k] != None || mesh.IsInfinite(cell.Neighbors[k]) ||
        cone.Old.Members().size() == LargestCavity)
      {
        return false;
      }
      cone.Old.Add(cell.Neighbors[k]);
    }
  }
  return true;
}
} // namespace

bool MovePoint(ExactState& state, Id point, const Point& place)
{
  if (!std::all_of(place.begin(), place.end(), [](double x) { return std::isfinite(x); }))
  {
    return false; // steps and averages of huge coordinates overflow
  }
  FlippableMesh& mesh = state.Mesh;
  Cone& cone = state.Scratch.Moved;
  std::vector<Id> star;
  mesh.Star(point, star);
  const Id marker = mesh.AddVertex(place);
  const bool canMove =
    Grow(mesh, star, cone, point, marker) && cone.Make(mesh, state.Segments, point, point, point);
  mesh.RemoveLastVertex();
  if (canMove)
  {
    mesh.Replace(cone.Old.Members(), cone.Fresh, cone.Facets);
    mesh.MoveVertex(point, place);
  }
  return canMove;
}

bool CollapsePoint(ExactState& state, Id point, const std::vector<Id>& neighbors)
{
  Cone& cone = state.Scratch.Moved;
  std::vector<Id> star;
  state.Mesh.Star(point, star);
  for (const Id neighbor : neighbors)
  {
    if (Grow(state.Mesh, star, cone, point, neighbor) &&
      cone.Make(state.Mesh, state.Segments, neighbor, point, point) && !cone.HasSurface())
    {
      state.Mesh.Replace(cone.Old.Members(), cone.Fresh);
      return true;
    }
  }
  return false;
}
} // namespace insideout
