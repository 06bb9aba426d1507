// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/PullVertex.h"

#include "Exact/SegmentWalk.h"

#include <algorithm>

namespace insideout
{
void VertexPuller::Add(Id cell)
{
  if (!this->Inside.Has(cell))
  {
    this->Inside.Add(cell);
    this->Cavity.push_back(cell);
  }
}

/**
 * Add the cells that a segment passes through, beginning at its other end, whose star is small.
 * @return false where the way is barred
 */
bool VertexPuller::AddCrossed(Id apex, Id other)
{
  this->Crossed.clear();
  Crossing crossing = FirstCrossing(this->Mesh, other, apex);
  for (; crossing.Kind == Crossing::ThroughFace || crossing.Kind == Crossing::ThroughEdge;
       crossing = NextCrossing(this->Mesh, other, apex, crossing))
  {
    if (crossing.Kind == Crossing::ThroughFace)
    {
      const FlippableCell& cell = this->Mesh.Cell(crossing.Cell);
      if (cell.Facets[crossing.Face] != None)
      {
        return false;
      }
      this->Crossed.insert(this->Crossed.end(), { crossing.Cell, cell.Neighbors[crossing.Face] });
      continue;
    }
    this->Mesh.Ring(crossing.U, crossing.V, crossing.Cell, this->Ring);
    if (this->Ring.IsLocked || this->Segments.Find(crossing.U, crossing.V) != None)
    {
      return false;
    }
    this->Crossed.insert(this->Crossed.end(), this->Ring.Cells.begin(), this->Ring.Cells.end());
  }
  this->Mesh.Work().Spend(static_cast<std::int64_t>(this->Crossed.size()));
  if (crossing.Kind != Crossing::AtEnd)
  {
    return false;
  }
  for (const Id cell : this->Crossed)
  {
    this->Add(cell);
  }
  return true;
}

/** Whether a fresh cell is turned as it should, be it beyond the hull. */
bool VertexPuller::Sees(const Tetrahedron& cell) const
{
  const int infinite = CornerIndexIn(cell, this->Mesh.Infinite());
  if (infinite < 0)
  {
    return this->Mesh.Vertices().Orient(cell[0], cell[1], cell[2], cell[3]) > 0;
  }
  Tetrahedron inner = cell;
  inner[infinite] = this->Mesh.VertexOffPlane(
    cell[(infinite + 1) % 4], cell[(infinite + 2) % 4], cell[(infinite + 3) % 4]);
  return inner[infinite] != None &&
    this->Mesh.Vertices().Orient(inner[0], inner[1], inner[2], inner[3]) < 0;
}

/** Whether the apex is in the plane of an infinite cell's face of the hull. */
bool VertexPuller::IsOnHullFace(Id cell, Id apex) const
{
  const int infinite = this->Mesh.CornerIndex(cell, this->Mesh.Infinite());
  if (infinite < 0 || this->Mesh.Has(cell, apex))
  {
    return true;
  }
  const Triangle face = this->Mesh.FaceCorners(cell, infinite);
  return this->Mesh.Vertices().Orient(face[0], face[1], face[2], apex) == 0;
}

/** Add the cells behind faces that do not see the apex. */
bool VertexPuller::Grow(Id apex)
{
  for (std::size_t next = 0; next < this->Cavity.size(); ++next)
  {
    const Id id = this->Cavity[next];
    if (!this->IsOnHullFace(id, apex))
    {
      return false;
    }
    const FlippableCell& cell = this->Mesh.Cell(id);
    const int at = this->Mesh.CornerIndex(id, apex);
    for (int k = 0; k < 4; ++k)
    {
      if ((at >= 0 && at != k) || this->Inside.Has(cell.Neighbors[k]))
      {
        continue;
      }
      Tetrahedron t = cell.Corners;
      t[k] = apex;
      if (!this->Sees(t))
      {
        if (cell.Facets[k] != None)
        {
          return false;
        }
        this->Add(cell.Neighbors[k]);
      }
    }
  }
  return true;
}

void VertexPuller::MakeCone(Id apex)
{
  this->Fresh.clear();
  this->Wall.Clear();
  for (const Id id : this->Cavity)
  {
    const FlippableCell& cell = this->Mesh.Cell(id);
    const int at = this->Mesh.CornerIndex(id, apex);
    for (int k = 0; k < 4; ++k)
    {
      if (this->Inside.Has(cell.Neighbors[k]))
      {
        continue;
      }
      if (at < 0 || at == k)
      {
        this->Fresh.push_back(cell.Corners);
        this->Fresh.back()[k] = apex;
      }
      this->Wall.Add(cell.Corners, k);
    }
  }
  this->Wall.Close();
}

/** Whether facets between cells that go are there afterwards, too: those that have the apex. */
bool VertexPuller::KeepsFacets(Id apex, Id id)
{
  const FlippableCell& cell = this->Mesh.Cell(id);
  const int at = this->Mesh.CornerIndex(id, apex);
  for (int k = 0; k < 4; ++k)
  {
    if (cell.Facets[k] == None || !this->Inside.Has(cell.Neighbors[k]))
    {
      continue;
    }
    if (at < 0 || at == k)
    {
      return false;
    }
    const auto& others = OtherCorners[k][at];
    const Id a = cell.Corners[others[0]];
    const Id b = cell.Corners[others[1]];
    if (!this->Wall.HasEdge(a, b))
    {
      return false;
    }
    this->SurfaceFaces.push_back({ a, b, cell.Facets[k] });
  }
  return true;
}

bool VertexPuller::KeepsConstraints(Id apex)
{
  this->SurfaceFaces.clear();
  for (const Id id : this->Cavity)
  {
    if (!this->Wall.Keeps(this->Mesh.Cell(id).Corners, apex, this->Segments) ||
      !this->KeepsFacets(apex, id))
    {
      return false;
    }
  }
  return true;
}

bool VertexPuller::Pull(Id apex, const std::vector<Id>& others)
{
  this->Cavity.clear();
  this->Inside.Start(this->Mesh.NumberOfCells());
  for (const Id other : others)
  {
    this->AddCrossed(apex, other);
  }
  const bool isCone = !this->Cavity.empty() && this->Grow(apex);
  this->Mesh.Work().Spend(static_cast<std::int64_t>(this->Cavity.size()));
  if (!isCone)
  {
    return false;
  }
  this->MakeCone(apex);
  if (this->Fresh.size() > this->Cavity.size() + others.size() / 2 || !this->KeepsConstraints(apex))
  {
    return false;
  }
  this->Mesh.Replace(this->Cavity, this->Fresh);
  for (const SurfaceFace& face : this->SurfaceFaces)
  {
    this->Mesh.MarkFace(apex, face.A, face.B, face.Facet);
  }
  return true;
}
} // namespace insideout
