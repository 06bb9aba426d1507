// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/FlipFlat.h"

#include "Exact/FlipTarget.h"
#include "Exact/SegmentWalk.h"

#include <algorithm>
#include <deque>

namespace insideout
{
namespace
{
/** Flips in a plane for each edge crossed. Where the plane is triangulated all over, few are
 * needed.
 */
constexpr std::size_t FlatFlipsPerCrossing = 8;

/**
 * Find two points of the edge's ring in one plane with the edge, on its two sides. They form a
 * strictly convex quadrilateral with it. Turn the ring so that it begins with the first.
 * @return the index of the second, 0 where there are none
 */
std::size_t FindQuadrilateral(const FlippableMesh& mesh, Id u, Id v, EdgeRing& ring)
{
  const ExactVertices& vertices = mesh.Vertices();
  const std::size_t n = ring.Points.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    for (std::size_t j = i + 1; j < n; ++j)
    {
      const Id p = ring.Points[i];
      const Id q = ring.Points[j];
      if (p == mesh.Infinite() || q == mesh.Infinite() || vertices.Orient(u, v, p, q) != 0)
      {
        continue;
      }
      const Id off = mesh.VertexOffPlane(u, v, p);
      const int side = vertices.Orient(u, p, v, off);
      if (vertices.Orient(v, q, u, off) == side && vertices.Orient(p, v, q, off) == side &&
        vertices.Orient(q, u, p, off) == side)
      {
        const auto shift = static_cast<std::ptrdiff_t>(i);
        std::rotate(ring.Points.begin(), ring.Points.begin() + shift, ring.Points.end());
        std::rotate(ring.Cells.begin(), ring.Cells.begin() + shift, ring.Cells.end());
        return j - i;
      }
    }
  }
  return 0;
}

/** The cells around an edge that no constraint has. */
bool FindRing(const ExactState& state, Id u, Id v, EdgeRing& ring)
{
  const Id cell = state.Mesh.FindEdge(u, v);
  if (cell == None || state.Segments.Find(u, v) != None)
  {
    return false;
  }
  state.Mesh.Ring(u, v, cell, ring);
  return !ring.IsLocked;
}

/** Append the outer faces of ring cell k. @return whether the cell is finite */
bool AddWalls(const FlippableMesh& mesh, const EdgeRing& ring, std::size_t k, Sector& sector)
{
  const Id x = ring.Points[k];
  const Id y = ring.Points[(k + 1) % ring.Points.size()];
  if (x == mesh.Infinite() || y == mesh.Infinite())
  {
    return false;
  }
  sector.Walls.push_back({ { y, x, ring.V } });
  sector.Walls.push_back({ { x, y, ring.U } });
  sector.Corners.insert(sector.Corners.end(), { x, y });
  return true;
}

Point MiddleOfEdge(const FlippableMesh& mesh, const EdgeRing& ring)
{
  const Point a = mesh.Vertices().Nearest(ring.U);
  const Point b = mesh.Vertices().Nearest(ring.V);
  return { { (a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2 } };
}

} // namespace

bool StarEdge(ExactState& state, Id u, Id v)
{
  FlippableMesh& mesh = state.Mesh;
  EdgeRing& ring = state.Scratch.Ring;
  if (!FindRing(state, u, v, ring))
  {
    return false;
  }
  std::vector<Sector> sectors(1);
  for (std::size_t k = 0; k < ring.Points.size(); ++k)
  {
    if (!AddWalls(mesh, ring, k, sectors[0]))
    {
      return false;
    }
  }
  std::vector<Tetrahedron> fresh;
  if (!FillSectors(mesh, sectors, MiddleOfEdge(mesh, ring), VolumePoints::AsNeeded, fresh))
  {
    return false;
  }
  mesh.Replace(ring.Cells, fresh);
  return true;
}

bool FlipFlat(ExactState& state, Id u, Id v, VolumePoints volumePoints, Id& p, Id& q)
{
  FlippableMesh& mesh = state.Mesh;
  EdgeRing& ring = state.Scratch.Ring;
  const std::size_t second = FindRing(state, u, v, ring) ? FindQuadrilateral(mesh, u, v, ring) : 0;
  if (second == 0)
  {
    return false;
  }
  p = ring.Points[0];
  q = ring.Points[second];
  std::vector<Sector> sectors(2);
  for (std::size_t k = 0; k < ring.Points.size(); ++k)
  {
    Sector& sector = sectors[k < second ? 0 : 1];
    sector.IsInfinite = !AddWalls(mesh, ring, k, sector) || sector.IsInfinite;
  }
  for (const Sector& sector : sectors)
  {
    if (sector.IsInfinite && !sector.Walls.empty())
    {
      return false;
    }
  }
  // The first sector goes around from p to q, the second from q to p.
  sectors[0].Walls.insert(sectors[0].Walls.end(), { { { p, q, v } }, { { q, p, u } } });
  sectors[1].Walls.insert(sectors[1].Walls.end(), { { { q, p, v } }, { { p, q, u } } });

  std::vector<Tetrahedron> fresh;
  if (!FillSectors(mesh, sectors, MiddleOfEdge(mesh, ring), volumePoints, fresh))
  {
    return false;
  }
  mesh.Replace(ring.Cells, fresh);
  return true;
}

bool MakeEdge(ExactState& state, Id a, Id b)
{
  const FlippableMesh& mesh = state.Mesh;
  std::deque<std::pair<Id, Id>> crossed;
  Crossing crossing = FirstCrossing(mesh, a, b);
  while (crossing.Kind == Crossing::ThroughEdge)
  {
    crossed.push_back({ crossing.U, crossing.V });
    crossing = NextCrossing(mesh, a, b, crossing);
  }
  if (crossing.Kind != Crossing::AtEnd)
  {
    return false;
  }
  const FlipTarget target = FlipTarget::Segment(mesh, a, b);
  std::size_t flips = FlatFlipsPerCrossing * crossed.size();
  std::size_t failed = 0; // since the last flip that was done
  while (failed < crossed.size() && flips > 0)
  {
    --flips;
    const auto [u, v] = crossed.front();
    crossed.pop_front();
    Id p;
    Id q;
    if (!FlipFlat(state, u, v, VolumePoints::AsNeeded, p, q))
    {
      crossed.push_back({ u, v });
      ++failed;
      continue;
    }
    failed = 0;
    if (target.CostOfEdge(p, q) > 0)
    {
      crossed.push_back({ p, q });
    }
  }
  return mesh.FindEdge(a, b) != None;
}
} // namespace insideout
