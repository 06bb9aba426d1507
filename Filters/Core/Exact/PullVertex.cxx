// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/PullVertex.h"

#include "Exact/SegmentWalk.h"

#include <algorithm>

namespace insideout
{
namespace
{
/**
 * Add the cells that a segment passes through, beginning at its other end, whose star is small.
 * @return whether no constraint or vertex obstructs it
 */
bool AddCrossed(ExactState& state, Id apex, Id other)
{
  const FlippableMesh& mesh = state.Mesh;
  EdgeRing& ring = state.Scratch.Ring;
  Cone& cone = state.Scratch.Moved;
  Crossing crossing = FirstCrossing(mesh, other, apex);
  for (; crossing.Kind == Crossing::ThroughFace || crossing.Kind == Crossing::ThroughEdge;
       crossing = NextCrossing(mesh, other, apex, crossing))
  {
    if (crossing.Kind == Crossing::ThroughFace)
    {
      const FlippableCell& cell = mesh.Cell(crossing.Cell);
      if (cell.Facets[crossing.Face] != None)
      {
        return false;
      }
      cone.Old.Add(crossing.Cell);
      cone.Old.Add(cell.Neighbors[crossing.Face]);
      continue;
    }
    mesh.Ring(crossing.U, crossing.V, crossing.Cell, ring);
    if (ring.IsLocked || state.Segments.Find(crossing.U, crossing.V) != None)
    {
      return false;
    }
    std::for_each(ring.Cells.begin(), ring.Cells.end(), [&cone](Id cell) { cone.Old.Add(cell); });
  }
  return crossing.Kind == Crossing::AtEnd;
}

/** Whether a new cell is positively oriented, infinite ones included. */
bool IsTurnedRight(const FlippableMesh& mesh, const Tetrahedron& cell)
{
  const int infinite = CornerIndexIn(cell, mesh.Infinite());
  if (infinite < 0)
  {
    return mesh.Vertices().Orient(cell[0], cell[1], cell[2], cell[3]) > 0;
  }
  Tetrahedron inner = cell;
  inner[infinite] = mesh.VertexOffPlane(
    cell[(infinite + 1) % 4], cell[(infinite + 2) % 4], cell[(infinite + 3) % 4]);
  return inner[infinite] != None &&
    mesh.Vertices().Orient(inner[0], inner[1], inner[2], inner[3]) < 0;
}

/** Whether the apex is in the plane of an infinite cell's face of the hull. */
bool IsOnHullFace(const FlippableMesh& mesh, Id cell, Id apex)
{
  const int infinite = mesh.CornerIndex(cell, mesh.Infinite());
  if (infinite < 0 || mesh.Has(cell, apex))
  {
    return true;
  }
  const Triangle face = mesh.FaceCorners(cell, infinite);
  return mesh.Vertices().Orient(face[0], face[1], face[2], apex) == 0;
}

/** Add the cells behind faces that do not see the apex. */
bool Grow(const FlippableMesh& mesh, Cone& cone, Id apex, std::size_t mostCells)
{
  for (std::size_t next = 0; next < cone.Old.Members().size(); ++next)
  {
    const Id id = cone.Old.Members()[next];
    if (cone.Old.Members().size() > mostCells || !IsOnHullFace(mesh, id, apex))
    {
      return false;
    }
    const FlippableCell& cell = mesh.Cell(id);
    const int at = mesh.CornerIndex(id, apex);
    for (int k = 0; k < 4; ++k)
    {
      if ((at >= 0 && at != k) || cone.Old.Has(cell.Neighbors[k]))
      {
        continue;
      }
      Tetrahedron t = cell.Corners;
      t[k] = apex;
      if (!IsTurnedRight(mesh, t))
      {
        if (cell.Facets[k] != None)
        {
          return false;
        }
        cone.Old.Add(cell.Neighbors[k]);
      }
    }
  }
  return true;
}
} // namespace

bool PullVertex(ExactState& state, Id apex, Id other, std::size_t mostCells)
{
  FlippableMesh& mesh = state.Mesh;
  Cone& cone = state.Scratch.Moved;
  cone.Old.Clear();
  const bool isCone = AddCrossed(state, apex, other) && Grow(mesh, cone, apex, mostCells);
  mesh.Work().Spend(static_cast<std::int64_t>(cone.Old.Members().size()));
  if (!isCone || !cone.Make(mesh, state.Segments, apex, apex))
  {
    return false;
  }
  mesh.Replace(cone.Old.Members(), cone.Fresh);
  cone.MarkSurface(mesh, apex);
  return true;
}
} // namespace insideout
