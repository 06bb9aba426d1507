// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/DissolvePoint.h"

#include "Common/SortUniquely.h"

#include <algorithm>

namespace insideout
{
namespace
{
/** Ways to triangulate fans that are tried: from one end, from the other, by cutting ears. */
constexpr int WaysToTriangulate = 3;

/** Whether the corners a, b, c of a cell and its fourth are an even permutation of its corners. */
bool IsEven(const FlippableMesh& mesh, Id cell, Id a, Id b, Id c)
{
  const auto& others = OtherCorners[mesh.CornerIndex(cell, a)][mesh.CornerIndex(cell, b)];
  return mesh.Cell(cell).Corners[others[0]] == c;
}
} // namespace

// --- What lies on the point ----------------------------------------------------------------------

void PointDissolver::FindSupport(Id point)
{
  this->Star.clear();
  this->Mesh.Star(point, this->Star);
  this->Segment = this->Segments.Around(point);
  if (this->Segment != None)
  {
    const std::array<Id, 2> ends = this->Segments.NeighborsOnPath(this->Segment, point);
    this->Before = ends[0];
    this->Behind = ends[1];
    if (this->Mesh.FindEdge(point, this->Before) == None ||
      this->Mesh.FindEdge(point, this->Behind) == None)
    {
      this->Star.clear(); // a segment that could be recovered in part only
    }
  }
}

bool PointDissolver::IsHullFace(Id cell, int face) const
{
  return this->Mesh.IsInfinite(cell) !=
    this->Mesh.IsInfinite(this->Mesh.Cell(cell).Neighbors[face]);
}

/** Continue a fan of two points. */
bool PointDissolver::FollowFan(Id point, bool onHull, Fan& fan) const
{
  const Id first = fan.Points[0];
  EdgeRing ring;
  while (this->Segment == None || fan.Points.back() != this->Behind)
  {
    const Id before = fan.Points[fan.Points.size() - 2];
    const Id here = fan.Points.back();
    this->Mesh.Ring(point, here, this->Mesh.FindEdge(point, here), ring);
    Id next = None;
    for (std::size_t k = 0; k < ring.Points.size() && next == None; ++k)
    {
      const Id cell = ring.Cells[k];
      const Id p = ring.Points[k];
      const int face = this->Mesh.CornerIndex(cell, ring.Points[(k + 1) % ring.Points.size()]);
      const bool belongs = fan.Facet != None ? this->Mesh.Cell(cell).Facets[face] == fan.Facet
                                             : onHull && this->IsHullFace(cell, face);
      if (belongs && p != before)
      {
        next = p;
      }
    }
    if (next == None)
    {
      return false;
    }
    if (next == first)
    {
      fan.IsClosed = true;
      return this->Segment == None;
    }
    fan.Points.push_back(next);
  }
  return true;
}

bool PointDissolver::FindFans(Id point)
{
  this->Fans.clear();
  if (this->Segment != None)
  {
    EdgeRing ring;
    this->Mesh.Ring(point, this->Before, this->Mesh.FindEdge(point, this->Before), ring);
    for (std::size_t k = 0; k < ring.Points.size(); ++k)
    {
      const Id cell = ring.Cells[k];
      const int face = this->Mesh.CornerIndex(cell, ring.Points[(k + 1) % ring.Points.size()]);
      const Id facet = this->Mesh.Cell(cell).Facets[face];
      const bool onHull = this->IsHullFace(cell, face);
      if (facet != None || onHull)
      {
        this->Fans.push_back({ facet, { this->Before, ring.Points[k] }, false, {} });
        if (!this->FollowFan(point, onHull, this->Fans.back()))
        {
          return false;
        }
      }
    }
    return true;
  }
  for (const bool facetsOnly : { true, false })
  {
    for (std::size_t k = 0; k < this->Star.size() && this->Fans.empty(); ++k)
    {
      const Id id = this->Star[k];
      const FlippableCell& cell = this->Mesh.Cell(id);
      const int corner = this->Mesh.CornerIndex(id, point);
      for (int face = 0; face < 4 && this->Fans.empty(); ++face)
      {
        const bool onHull = this->IsHullFace(id, face);
        if (face == corner || (facetsOnly ? cell.Facets[face] == None : !onHull))
        {
          continue;
        }
        Fan fan = { cell.Facets[face], {}, false, {} };
        for (int j = 0; j < 4; ++j)
        {
          if (j != face && j != corner)
          {
            fan.Points.push_back(cell.Corners[j]);
          }
        }
        this->Fans.push_back(fan);
        if (!this->FollowFan(point, onHull, this->Fans.back()))
        {
          return false;
        }
      }
    }
  }
  return true;
}

/**
 * Free pairs of faces between the segment's two halves: cells beyond them need not be seen.
 * @return whether there is any
 */
bool PointDissolver::AddSeparators(Id point)
{
  const std::size_t fans = this->Fans.size();
  EdgeRing before;
  EdgeRing behind;
  this->Mesh.Ring(point, this->Before, this->Mesh.FindEdge(point, this->Before), before);
  this->Mesh.Ring(point, this->Behind, this->Mesh.FindEdge(point, this->Behind), behind);
  for (const Id p : before.Points)
  {
    const bool isTaken = std::any_of(this->Fans.begin(), this->Fans.end(),
      [p](const Fan& fan)
      { return std::find(fan.Points.begin(), fan.Points.end(), p) != fan.Points.end(); });
    if (!isTaken && p != this->Mesh.Infinite() &&
      std::find(behind.Points.begin(), behind.Points.end(), p) != behind.Points.end())
    {
      this->Fans.push_back({ None, { this->Before, p, this->Behind }, false, {} });
    }
  }
  return this->Fans.size() > fans;
}

bool PointDissolver::IsWall(Id point, Id cell, int face) const
{
  if (this->Mesh.Cell(cell).Facets[face] != None || this->IsHullFace(cell, face))
  {
    return true;
  }
  // A face between the two halves of a separator.
  if (this->Segment == None)
  {
    return false;
  }
  Id third = None;
  bool onSegment = false;
  for (int k = 0; k < 4; ++k)
  {
    const Id corner = this->Mesh.Cell(cell).Corners[k];
    if (k == face || corner == point)
    {
      continue;
    }
    if (corner == this->Before || corner == this->Behind)
    {
      onSegment = true;
    }
    else
    {
      third = corner;
    }
  }
  return onSegment &&
    std::any_of(this->Fans.begin(), this->Fans.end(),
      [&](const Fan& fan) { return fan.Points.size() == 3 && fan.Points[1] == third; });
}

// --- Triangulating facets without the point ------------------------------------------------------

bool PointDissolver::CutEars(Id off, int side, Fan& fan, int start) const
{
  const ExactVertices& vertices = this->Mesh.Vertices();
  std::vector<Id> rest = fan.Points;
  std::rotate(rest.begin(), rest.begin() + start % static_cast<int>(rest.size()), rest.end());
  while (rest.size() > 3)
  {
    const std::size_t n = rest.size();
    std::size_t ear = n;
    for (std::size_t k = 0; k < n && ear == n; ++k)
    {
      const Id a = rest[(k + n - 1) % n];
      const Id b = rest[k];
      const Id c = rest[(k + 1) % n];
      const auto isInside = [&](Id p)
      {
        return p != a && p != b && p != c && side * vertices.Orient(a, b, p, off) >= 0 &&
          side * vertices.Orient(b, c, p, off) >= 0 && side * vertices.Orient(c, a, p, off) >= 0;
      };
      if (side * vertices.Orient(a, b, c, off) > 0 &&
        std::none_of(rest.begin(), rest.end(), isInside))
      {
        ear = k;
      }
    }
    if (ear == n)
    {
      return false;
    }
    fan.Pieces.push_back({ { rest[(ear + n - 1) % n], rest[ear], rest[(ear + 1) % n] } });
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  fan.Pieces.push_back({ { rest[0], rest[1], rest[2] } });
  return side * vertices.Orient(rest[0], rest[1], rest[2], off) > 0;
}

bool PointDissolver::TriangulateFans(Id point, int way)
{
  for (Fan& fan : this->Fans)
  {
    fan.Pieces.clear();
    const Id off = this->Mesh.VertexOffPlane(point, fan.Points[0], fan.Points[1]);
    if (off == None)
    {
      return false;
    }
    const int side = this->Mesh.Vertices().Orient(point, fan.Points[0], fan.Points[1], off);
    const std::size_t n = fan.Points.size();
    const bool isFlat = std::all_of(fan.Points.begin(), fan.Points.end(),
      [&](Id p)
      { return this->Mesh.Vertices().Orient(point, fan.Points[0], fan.Points[1], p) == 0; });
    if (n < 3 || !isFlat)
    {
      return false;
    }
    if (way == WaysToTriangulate - 1 || fan.IsClosed)
    {
      if (!this->CutEars(off, side, fan, way))
      {
        return false;
      }
      continue;
    }
    const std::size_t center = way == 0 ? 0 : n - 1;
    for (std::size_t k = way == 0 ? 1 : 0; k + (way == 0 ? 1 : 2) < n; ++k)
    {
      const Triangle piece = { { fan.Points[k], fan.Points[k + 1], fan.Points[center] } };
      if (side * this->Mesh.Vertices().Orient(piece[0], piece[1], piece[2], off) <= 0)
      {
        return false;
      }
      fan.Pieces.push_back(piece);
    }
  }
  return true;
}

// --- Sectors -------------------------------------------------------------------------------------

bool PointDissolver::FindSectors(Id point)
{
  this->Sectors.clear();
  this->SectorOf.resize(static_cast<std::size_t>(this->Mesh.NumberOfCells()));
  for (const Id cell : this->Star)
  {
    this->SectorOf[cell] = None;
  }
  std::vector<Id> cells;
  for (const Id seed : this->Star)
  {
    if (this->SectorOf[seed] != None)
    {
      continue;
    }
    const Id number = static_cast<Id>(this->Sectors.size());
    this->Sectors.emplace_back();
    Sector& sector = this->Sectors.back();
    sector.IsInfinite = this->Mesh.IsInfinite(seed);
    this->SectorOf[seed] = number;
    cells.assign(1, seed);
    for (std::size_t next = 0; next < cells.size(); ++next)
    {
      const Id id = cells[next];
      this->AddOuterWall(point, id, sector);
      for (int k = 0; k < 4; ++k)
      {
        const FlippableCell& cell = this->Mesh.Cell(id);
        if (cell.Corners[k] == point)
        {
          continue;
        }
        Id& neighbors = this->SectorOf[cell.Neighbors[k]];
        if (neighbors == None && !this->IsWall(point, id, k))
        {
          neighbors = number;
          cells.push_back(cell.Neighbors[k]);
        }
      }
    }
    SortUniquely(sector.Corners);
  }
  return this->AddFanWalls(point);
}

/** A cell's face across from the point is a wall. */
void PointDissolver::AddOuterWall(Id point, Id cell, Sector& sector) const
{
  if (sector.IsInfinite)
  {
    return;
  }
  const int corner = this->Mesh.CornerIndex(cell, point);
  sector.Walls.push_back(this->Mesh.FaceCorners(cell, corner));
  sector.Corners.insert(
    sector.Corners.end(), sector.Walls.back().begin(), sector.Walls.back().end());
}

/** Each fan is a wall of the sectors on its two sides, which must be two. */
bool PointDissolver::AddFanWalls(Id point)
{
  for (const Fan& fan : this->Fans)
  {
    Id cell;
    int face;
    if (!this->Mesh.FindFace(point, fan.Points[0], fan.Points[1], cell, face))
    {
      return false;
    }
    const Id other = this->Mesh.Cell(cell).Neighbors[face];
    if (this->SectorOf[cell] == this->SectorOf[other])
    {
      return false;
    }
    for (const Id side : { cell, other })
    {
      const bool even = IsEven(this->Mesh, side, point, fan.Points[0], fan.Points[1]);
      std::vector<Triangle>& walls = this->Sectors[this->SectorOf[side]].Walls;
      for (Triangle piece : fan.Pieces)
      {
        if (!even)
        {
          std::swap(piece[0], piece[1]);
        }
        walls.push_back(piece);
      }
    }
  }
  return true;
}

// --- All together --------------------------------------------------------------------------------

void PointDissolver::MarkPieces() const
{
  for (const Fan& fan : this->Fans)
  {
    for (const Triangle& piece : fan.Pieces)
    {
      this->Mesh.MarkFace(piece[0], piece[1], piece[2], fan.Facet);
    }
  }
}

bool PointDissolver::Fill(Id point, VolumePoints volumePoints)
{
  // Where nothing but the segment itself is to stay, it does so if all cells meet in one of its
  // ends.
  if (this->Fans.empty())
  {
    volumePoints = VolumePoints::None;
    if (this->Segment != None)
    {
      this->Sectors[0].Corners = { this->Before, this->Behind };
    }
  }
  std::vector<Tetrahedron> fresh;
  if (!this->Filler.Fill(this->Sectors, this->Mesh.Vertices().Nearest(point), volumePoints, fresh))
  {
    return false;
  }
  this->Mesh.Replace(this->Star, fresh);
  this->MarkPieces();
  if (this->Segment != None)
  {
    this->Segments.Join(this->Segment, point);
  }
  return true;
}

bool PointDissolver::Dissolve(Id point, VolumePoints volumePoints)
{
  this->FindSupport(point);
  for (const bool separate : { false, true })
  {
    if (this->Star.empty() || (separate && this->Segment == None) || !this->FindFans(point) ||
      (separate && !this->AddSeparators(point)))
    {
      return false;
    }
    const bool oneWay = std::all_of(
      this->Fans.begin(), this->Fans.end(), [](const Fan& fan) { return fan.Points.size() <= 3; });
    for (int way = 0; way < (oneWay ? 1 : WaysToTriangulate); ++way)
    {
      if (this->TriangulateFans(point, way) && this->FindSectors(point) &&
        this->Fill(point, volumePoints))
      {
        return true;
      }
    }
  }
  return false;
}
} // namespace insideout
