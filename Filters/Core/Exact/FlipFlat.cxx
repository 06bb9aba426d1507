// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/FlipFlat.h"

#include "Exact/EngineLimits.h"
#include "Exact/FlipTarget.h"
#include "Exact/SegmentWalk.h"

#include <algorithm>
#include <deque>

namespace insideout
{
/**
 * Find two points of the edge's ring in one plane with it, on its two sides, that are a strictly
 * convex quadrilateral with it, and turn the ring so that it begins with the first.
 */
bool FlatFlipper::FindQuadrilateral(Id u, Id v)
{
  const ExactVertices& vertices = this->Mesh.Vertices();
  EdgeRing& ring = this->Ring;
  const std::size_t n = ring.Points.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    for (std::size_t j = i + 1; j < n; ++j)
    {
      const Id p = ring.Points[i];
      const Id q = ring.Points[j];
      if (p == this->Mesh.Infinite() || q == this->Mesh.Infinite() ||
        vertices.Orient(u, v, p, q) != 0)
      {
        continue;
      }
      const Id off = this->Mesh.VertexOffPlane(u, v, p);
      const int side = vertices.Orient(u, p, v, off);
      if (vertices.Orient(v, q, u, off) == side && vertices.Orient(p, v, q, off) == side &&
        vertices.Orient(q, u, p, off) == side)
      {
        const auto shift = static_cast<std::ptrdiff_t>(i);
        std::rotate(ring.Points.begin(), ring.Points.begin() + shift, ring.Points.end());
        std::rotate(ring.Cells.begin(), ring.Cells.begin() + shift, ring.Cells.end());
        this->Second = j - i;
        return true;
      }
    }
  }
  return false;
}

/** The cells around an edge that no constraint has. */
bool FlatFlipper::FindRing(Id u, Id v)
{
  const Id cell = this->Mesh.FindEdge(u, v);
  if (cell == None || this->Segments.Find(u, v) != None)
  {
    return false;
  }
  this->Mesh.Ring(u, v, cell, this->Ring);
  return !this->Ring.IsLocked;
}

/** Append the outer faces of ring cell k. @return whether the cell is finite */
bool FlatFlipper::AddWalls(std::size_t k, Sector& sector) const
{
  const Id x = this->Ring.Points[k];
  const Id y = this->Ring.Points[(k + 1) % this->Ring.Points.size()];
  if (x == this->Mesh.Infinite() || y == this->Mesh.Infinite())
  {
    return false;
  }
  sector.Walls.push_back({ { y, x, this->Ring.V } });
  sector.Walls.push_back({ { x, y, this->Ring.U } });
  sector.Corners.insert(sector.Corners.end(), { x, y });
  return true;
}

Point FlatFlipper::MiddleOfEdge() const
{
  const Point a = this->Mesh.Vertices().Nearest(this->Ring.U);
  const Point b = this->Mesh.Vertices().Nearest(this->Ring.V);
  return { { (a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2 } };
}

bool FlatFlipper::StarEdge(Id u, Id v)
{
  if (!this->FindRing(u, v))
  {
    return false;
  }
  std::vector<Sector> sectors(1);
  for (std::size_t k = 0; k < this->Ring.Points.size(); ++k)
  {
    if (!this->AddWalls(k, sectors[0]))
    {
      return false;
    }
  }
  std::vector<Tetrahedron> fresh;
  if (!this->Filler.Fill(sectors, this->MiddleOfEdge(), VolumePoints::AsNeeded, fresh))
  {
    return false;
  }
  this->Mesh.Replace(std::vector<Id>(this->Ring.Cells), fresh);
  return true;
}

bool FlatFlipper::Flip(Id u, Id v, VolumePoints volumePoints, Id& p, Id& q)
{
  if (!this->FindRing(u, v))
  {
    return false;
  }
  const EdgeRing& ring = this->Ring;
  const std::size_t n = ring.Points.size();
  if (!this->FindQuadrilateral(u, v))
  {
    return false;
  }
  p = ring.Points[0];
  q = ring.Points[this->Second];
  std::vector<Sector> sectors(2);
  for (std::size_t k = 0; k < n; ++k)
  {
    Sector& sector = sectors[k < this->Second ? 0 : 1];
    sector.IsInfinite = !this->AddWalls(k, sector) || sector.IsInfinite;
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
  if (!this->Filler.Fill(sectors, this->MiddleOfEdge(), volumePoints, fresh))
  {
    return false;
  }
  this->Mesh.Replace(std::vector<Id>(ring.Cells), fresh);
  return true;
}

bool FlatFlipper::MakeEdge(Id a, Id b)
{
  std::deque<std::pair<Id, Id>> crossed;
  Crossing crossing = FirstCrossing(this->Mesh, a, b);
  while (crossing.Kind == Crossing::ThroughEdge)
  {
    crossed.push_back({ crossing.U, crossing.V });
    crossing = NextCrossing(this->Mesh, a, b, crossing);
  }
  if (crossing.Kind != Crossing::AtEnd)
  {
    return false;
  }
  const FlipTarget target = FlipTarget::Segment(this->Mesh, a, b);
  std::size_t flips = EngineLimits::FlatFlipsPerCrossing * crossed.size();
  std::size_t failed = 0; // since the last flip that was done
  while (failed < crossed.size() && flips > 0)
  {
    --flips;
    const auto [u, v] = crossed.front();
    crossed.pop_front();
    Id p;
    Id q;
    if (!this->Flip(u, v, VolumePoints::AsNeeded, p, q))
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
  return this->Mesh.FindEdge(a, b) != None;
}
} // namespace insideout
