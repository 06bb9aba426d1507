// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/SegmentWalk.h"

#include <algorithm>

namespace insideout
{
namespace
{
/** Limit of steps from cell to cell around a point: most stars have some twenty cells. */
constexpr int StepsInStar = 40;

Crossing End(Id cell)
{
  return { Crossing::AtEnd, cell, -1, None, None };
}

Crossing Vertex(Id cell)
{
  return { Crossing::AtVertex, cell, -1, None, None };
}

Crossing Edge(Id cell, Id u, Id v)
{
  return { Crossing::ThroughEdge, cell, -1, u, v };
}

Crossing Face(Id cell, int face)
{
  return { Crossing::ThroughFace, cell, face, None, None };
}

/** A finite cell, seen from its corner a. */
struct Cone
{
  Triangle Link;            ///< the face across from a, counter-clockwise seen from a
  std::array<int, 3> Sides; ///< of b: positive if it is inside of a, Link[k] and the next
  int Outside;              ///< the first k with a negative side, -1 if b is within
};

Cone ConeTowards(const MeshReader& mesh, Id a, Id b, Id cell)
{
  Cone cone = { mesh->FaceCorners(cell, mesh->CornerIndex(cell, a)), {}, -1 };
  for (int k = 0; k < 3 && cone.Outside < 0; ++k)
  {
    cone.Sides[k] = -mesh.Orient(a, cone.Link[k], cone.Link[(k + 1) % 3], b);
    cone.Outside = cone.Sides[k] < 0 ? k : -1;
  }
  return cone;
}

/** The crossing at which the segment from a leaves the cell whose cone contains it. */
Crossing WayOut(const MeshReader& mesh, Id a, Id cell, const Cone& cone)
{
  const std::array<int, 3>& sides = cone.Sides;
  const auto zeros = std::count(sides.begin(), sides.end(), 0);
  if (zeros == 0)
  {
    return Face(cell, mesh->CornerIndex(cell, a));
  }
  if (zeros > 1)
  {
    const int between = sides[0] != 0 ? 2 : sides[1] != 0 ? 0 : 1;
    return { Crossing::AtVertex, cell, -1, cone.Link[between], None };
  }
  const auto k = std::find(sides.begin(), sides.end(), 0) - sides.begin();
  return Edge(cell, cone.Link[k], cone.Link[(k + 1) % 3]);
}

/** The cell around a whose cone contains b. */
Crossing SearchStar(const MeshReader& mesh, Id a, Id b)
{
  std::vector<Id> star;
  mesh.Star(a, star);
  for (const Id cell : star)
  {
    if (mesh->Has(cell, b))
    {
      return End(cell);
    }
    if (mesh->IsInfinite(cell))
    {
      continue;
    }
    const Cone cone = ConeTowards(mesh, a, b, cell);
    if (cone.Outside < 0)
    {
      return WayOut(mesh, a, cell, cone);
    }
  }
  return Vertex(star.empty() ? None : star[0]);
}

Crossing AfterFace(const MeshReader& mesh, Id a, Id b, const Crossing& crossing)
{
  const FlippableCell& before = mesh->Cell(crossing.Cell);
  const Id cell = before.Neighbors[crossing.Face];
  if (mesh->Has(cell, b))
  {
    return End(cell);
  }
  const Id apex = mesh->Opposite(crossing.Cell, crossing.Face);
  if (apex == mesh->Infinite())
  {
    return Vertex(cell);
  }
  const Triangle f = mesh->FaceCorners(crossing.Cell, crossing.Face);
  const int turn = mesh.Orient(a, b, f[0], f[1]);
  std::array<int, 3> s;
  for (int k = 0; k < 3; ++k)
  {
    s[k] = turn * mesh.Orient(a, b, f[k], apex);
  }
  for (int k = 0; k < 3; ++k)
  {
    if (s[k] == 0 && s[(k + 1) % 3] > 0)
    {
      return Edge(cell, f[k], apex);
    }
    if (s[k] < 0 && s[(k + 1) % 3] > 0)
    {
      return Face(cell, mesh->CornerIndex(cell, f[(k + 2) % 3]));
    }
  }
  return Vertex(cell);
}

/**
 * Beyond the edge uv the segment lies in the face (u, v, p) of `cell`, whose fourth corner is q.
 */
Crossing WithinFace(const MeshReader& mesh, Id a, Id b, Id cell, Id u, Id v, Id p, Id q)
{
  const int atP = mesh.Orient(a, b, p, q);
  if (atP == 0)
  {
    return Vertex(cell);
  }
  return Edge(cell, atP == mesh.Orient(a, b, u, q) ? v : u, p);
}

Crossing AfterEdge(const MeshReader& mesh, Id a, Id b, const Crossing& crossing)
{
  const Id u = crossing.U;
  const Id v = crossing.V;
  EdgeRing ring;
  mesh->Ring(u, v, crossing.Cell, ring);
  const std::size_t n = ring.Points.size();
  for (std::size_t k = 0; k < n; ++k)
  {
    if (ring.Points[k] == b)
    {
      return End(ring.Cells[k]);
    }
  }
  for (std::size_t k = 0; k < n; ++k)
  {
    const Id p = ring.Points[k];
    const Id q = ring.Points[(k + 1) % n];
    const Id cell = ring.Cells[k];
    if (p == mesh->Infinite() || q == mesh->Infinite())
    {
      continue;
    }
    const int fromP = mesh.Orient(u, v, p, b);
    const int toQ = mesh.Orient(u, v, b, q);
    if (fromP > 0 && toQ > 0)
    {
      const int across = mesh.Orient(a, b, p, q);
      if (across == 0)
      {
        return Edge(cell, p, q);
      }
      return Face(cell, mesh->CornerIndex(cell, across == mesh.Orient(a, b, u, p) ? v : u));
    }
    if (fromP == 0 && toQ > 0)
    {
      return WithinFace(mesh, a, b, cell, u, v, p, q);
    }
    if (fromP > 0 && toQ == 0)
    {
      return WithinFace(mesh, a, b, cell, u, v, q, p);
    }
  }
  return Vertex(crossing.Cell);
}
} // namespace

Crossing FirstCrossing(const MeshReader& mesh, Id a, Id b)
{
  Id cell = mesh->CellAt(a);
  if (cell != None && mesh->IsInfinite(cell))
  {
    cell = mesh->Cell(cell).Neighbors[mesh->CornerIndex(cell, mesh->Infinite())];
  }
  // Walk around a, from cell to cell across a side that b is beyond. The walk may be cyclic.
  for (int step = 0; step < StepsInStar && cell != None && !mesh->IsInfinite(cell); ++step)
  {
    if (mesh->Has(cell, b))
    {
      return End(cell);
    }
    const Cone cone = ConeTowards(mesh, a, b, cell);
    if (cone.Outside < 0)
    {
      return WayOut(mesh, a, cell, cone);
    }
    const Id off = cone.Link[(cone.Outside + 2) % 3];
    cell = mesh->Cell(cell).Neighbors[mesh->CornerIndex(cell, off)];
  }
  return SearchStar(mesh, a, b);
}

Crossing NextCrossing(const MeshReader& mesh, Id a, Id b, const Crossing& crossing)
{
  return crossing.Kind == Crossing::ThroughFace ? AfterFace(mesh, a, b, crossing)
                                                : AfterEdge(mesh, a, b, crossing);
}
} // namespace insideout
