// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/Cone.h"

namespace insideout
{
namespace
{
/** Each cell has six edges. */
constexpr std::size_t MostEdgesPerCell = 6;
} // namespace

/**
 * Whether all corners of a cell except the center, and the segments between them, are on the wall.
 */
bool Cone::Keeps(const Tetrahedron& cell, Id centre, const SegmentTable& segments) const
{
  for (int k = 0; k < 4; ++k)
  {
    const Id u = cell[k];
    if (u == centre)
    {
      continue;
    }
    if (!this->OnWall.Has(u))
    {
      return false;
    }
    for (int j = 0; j < k; ++j)
    {
      const Id v = cell[j];
      if (v != centre && !this->WallEdges.Has(u, v) && segments.Find(u, v) != None)
      {
        return false;
      }
    }
  }
  return true;
}

bool Cone::Make(
  const FlippableMesh& mesh, const SegmentTable& segments, Id apex, Id centre, Id gone)
{
  this->Fresh.clear();
  this->OnWall.Clear();
  this->WallEdges.Start(MostEdgesPerCell * this->Old.Members().size());
  this->Facets.clear();
  const auto isWall = [&](const FlippableCell& cell, int at, int k)
  { return (at < 0 || at == k) && !this->Old.Has(cell.Neighbors[k]); };
  for (const Id id : this->Old.Members())
  {
    const FlippableCell& cell = mesh.Cell(id);
    const int atGone = CornerIndexIn(cell.Corners, gone);
    const int atApex = CornerIndexIn(cell.Corners, apex);
    for (int k = 0; k < 4; ++k)
    {
      if (!isWall(cell, atGone, k))
      {
        continue;
      }
      if (atApex < 0 || atApex == k)
      {
        this->Fresh.push_back(cell.Corners);
        this->Fresh.back()[k] = apex;
      }
      const Triangle face = mesh.FaceCorners(id, k);
      for (int j = 0; j < 3; ++j)
      {
        this->OnWall.Add(face[j]);
        this->WallEdges.Add(face[j], face[(j + 1) % 3]);
      }
    }
  }
  for (const Id id : this->Old.Members())
  {
    const FlippableCell& cell = mesh.Cell(id);
    if (!this->Keeps(cell.Corners, centre, segments))
    {
      return false;
    }
    const int atGone = CornerIndexIn(cell.Corners, gone);
    const int at = CornerIndexIn(cell.Corners, centre);
    for (int k = 0; k < 4; ++k)
    {
      const bool isHull = !this->Old.Has(cell.Neighbors[k]) && mesh.IsInfinite(cell.Neighbors[k]);
      if (isWall(cell, atGone, k) || (cell.Facets[k] == None && !isHull))
      {
        continue;
      }
      const auto& others = OtherCorners[k][at < 0 ? k : at];
      const Id a = cell.Corners[others[0]];
      const Id b = cell.Corners[others[1]];
      if (at < 0 || at == k || !this->WallEdges.Has(a, b))
      {
        return false;
      }
      this->Facets.push_back({ { { centre, a, b } }, cell.Facets[k] });
    }
  }
  return true;
}
} // namespace insideout
