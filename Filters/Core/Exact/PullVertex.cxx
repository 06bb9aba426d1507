// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/PullVertex.h"

#include "Exact/SegmentWalk.h"

#include <algorithm>

namespace insideout
{
namespace
{
/** Add the cells that a segment passes through, beginning at its other end, whose star is small. */
Pull AddCrossed(const MeshReader& mesh, const SegmentTable& segments, Id apex, Id other,
  EdgeRing& ring, Cone& cone)
{
  Crossing crossing = FirstCrossing(mesh, other, apex);
  for (; crossing.Kind == Crossing::ThroughFace || crossing.Kind == Crossing::ThroughEdge;
       crossing = NextCrossing(mesh, other, apex, crossing))
  {
    if (!mesh.Holds(crossing.Cell))
    {
      return Pull::Beyond;
    }
    if (crossing.Kind == Crossing::ThroughFace)
    {
      const FlippableCell& cell = mesh->Cell(crossing.Cell);
      if (cell.Facets[crossing.Face] != None)
      {
        return Pull::Obstructed;
      }
      cone.Old.Add(crossing.Cell);
      cone.Old.Add(cell.Neighbors[crossing.Face]);
      continue;
    }
    mesh->Ring(crossing.U, crossing.V, crossing.Cell, ring);
    if (ring.IsLocked || segments.Find(crossing.U, crossing.V) != None)
    {
      return Pull::Obstructed;
    }
    for (const Id cell : ring.Cells)
    {
      cone.Old.Add(cell);
    }
  }
  return crossing.Kind == Crossing::AtEnd ? Pull::Made : Pull::Obstructed;
}

/** Whether a new cell is positively oriented, infinite ones included. */
bool IsTurnedRight(const MeshReader& mesh, const Tetrahedron& cell)
{
  const int infinite = CornerIndexIn(cell, mesh->Infinite());
  if (infinite < 0)
  {
    return mesh.Orient(cell[0], cell[1], cell[2], cell[3]) > 0;
  }
  Tetrahedron inner = cell;
  inner[infinite] = mesh.VertexOffPlane(
    cell[(infinite + 1) % 4], cell[(infinite + 2) % 4], cell[(infinite + 3) % 4]);
  return inner[infinite] != None && mesh.Orient(inner[0], inner[1], inner[2], inner[3]) < 0;
}

/** Whether the apex is in the plane of an infinite cell's face of the hull. */
bool IsOnHullFace(const MeshReader& mesh, Id cell, Id apex)
{
  const int infinite = mesh->CornerIndex(cell, mesh->Infinite());
  if (infinite < 0 || mesh->Has(cell, apex))
  {
    return true;
  }
  const Triangle face = mesh->FaceCorners(cell, infinite);
  return mesh.Orient(face[0], face[1], face[2], apex) == 0;
}

/** Add the cells behind faces that do not see the apex. */
Pull Grow(const MeshReader& mesh, Cone& cone, Id apex, std::size_t mostCells)
{
  for (std::size_t next = 0; next < cone.Old.Members().size(); ++next)
  {
    const Id id = cone.Old.Members()[next];
    if (!mesh.Holds(id))
    {
      return Pull::Beyond;
    }
    if (cone.Old.Members().size() > mostCells || !IsOnHullFace(mesh, id, apex))
    {
      return Pull::Obstructed;
    }
    const FlippableCell& cell = mesh->Cell(id);
    const int at = mesh->CornerIndex(id, apex);
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
          return Pull::Obstructed;
        }
        cone.Old.Add(cell.Neighbors[k]);
      }
    }
  }
  return Pull::Made;
}
} // namespace

Pull MakePull(const MeshReader& mesh, const SegmentTable& segments, Id apex, Id other,
  std::size_t mostCells, EdgeRing& ring, Cone& cone)
{
  cone.Old.Clear();
  Pull pull = AddCrossed(mesh, segments, apex, other, ring, cone);
  if (pull == Pull::Made)
  {
    pull = Grow(mesh, cone, apex, mostCells);
  }
  mesh.Spend(static_cast<std::int64_t>(cone.Old.Members().size()));
  return pull == Pull::Made && !cone.Make(*mesh, segments, apex, apex) ? Pull::Obstructed : pull;
}

bool PullVertex(ExactState& state, Id apex, Id other, std::size_t mostCells)
{
  FlippableMesh& mesh = state.Mesh;
  Cone& cone = state.Scratch.Moved;
  if (MakePull(mesh, state.Segments, apex, other, mostCells, state.Scratch.Ring, cone) !=
    Pull::Made)
  {
    return false;
  }
  mesh.Replace(cone.Old.Members(), cone.Fresh, cone.Facets);
  return true;
}
} // namespace insideout
