// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/DissolvePoint.h"

#include "Common/SortUniquely.h"

#include <algorithm>

namespace insideout
{
namespace
{
/** Number of ways tried to triangulate a fan: from one end, from the other, by cutting ears. */
constexpr int WaysToTriangulate = 3;

/** Faces in one plane around the point: from one edge at the point to another, or a full disk. */
struct Fan
{
  Id Facet;               ///< None for faces of the hull and for free faces that separate sectors
  std::vector<Id> Points; ///< the other ends of the edges from the point, in order
  bool IsClosed;          ///< the last point is adjacent to the first
  std::vector<Triangle> Pieces;
};

/** The star of the point to remove, its segment, and the fans and sectors around it. */
struct Surroundings
{
  Id Point;
  std::vector<Id> Star;
  Id Segment; ///< split by the point, None for none, and its neighbors there
  Id Before = None;
  Id Behind = None;
  std::vector<Fan> Fans;
  std::vector<Sector> Sectors;
};

/** Whether the corners a, b, c and the fourth one are an even permutation of the cell's corners. */
bool IsEven(const FlippableMesh& mesh, Id cell, Id a, Id b, Id c)
{
  const auto& others = OtherCorners[mesh.CornerIndex(cell, a)][mesh.CornerIndex(cell, b)];
  return mesh.Cell(cell).Corners[others[0]] == c;
}

// --- The surroundings of the point ---------------------------------------------------------------

/** @return whether the segment, if there is one, continues on both sides */
bool FindStar(const ExactState& state, Surroundings& around)
{
  const FlippableMesh& mesh = state.Mesh;
  mesh.Star(around.Point, around.Star);
  around.Segment = state.Segments.Around(around.Point);
  if (around.Segment == None)
  {
    return !around.Star.empty();
  }
  const std::array<Id, 2> ends = state.Segments.NeighborsOnPath(around.Segment, around.Point);
  around.Before = ends[0];
  around.Behind = ends[1];
  return !around.Star.empty() && mesh.FindEdge(around.Point, around.Before) != None &&
    mesh.FindEdge(around.Point, around.Behind) != None;
}

/** The cells around the edge from the point to another. */
EdgeRing RingTo(const FlippableMesh& mesh, Id point, Id other)
{
  EdgeRing ring;
  mesh.Ring(point, other, mesh.FindEdge(point, other), ring);
  return ring;
}

/** The face between cell k of a ring and its predecessor, as seen from cell k. */
int FaceAt(const FlippableMesh& mesh, const EdgeRing& ring, std::size_t k)
{
  return mesh.CornerIndex(ring.Cells[k], ring.Points[(k + 1) % ring.Points.size()]);
}

bool IsHullFace(const FlippableMesh& mesh, Id cell, int face)
{
  return mesh.IsInfinite(cell) != mesh.IsInfinite(mesh.Cell(cell).Neighbors[face]);
}

/** Continue a fan of two points. */
bool FollowFan(const FlippableMesh& mesh, const Surroundings& around, bool onHull, Fan& fan)
{
  const Id first = fan.Points[0];
  while (around.Segment == None || fan.Points.back() != around.Behind)
  {
    const Id before = fan.Points[fan.Points.size() - 2];
    const Id here = fan.Points.back();
    const EdgeRing ring = RingTo(mesh, around.Point, here);
    Id next = None;
    for (std::size_t k = 0; k < ring.Points.size() && next == None; ++k)
    {
      const Id cell = ring.Cells[k];
      const Id p = ring.Points[k];
      const int face = FaceAt(mesh, ring, k);
      const bool belongs = fan.Facet != None ? mesh.Cell(cell).Facets[face] == fan.Facet
                                             : onHull && IsHullFace(mesh, cell, face);
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
      return around.Segment == None;
    }
    fan.Points.push_back(next);
  }
  return true;
}

bool FindFans(const FlippableMesh& mesh, Surroundings& around)
{
  around.Fans.clear();
  if (around.Segment != None)
  {
    const EdgeRing ring = RingTo(mesh, around.Point, around.Before);
    for (std::size_t k = 0; k < ring.Points.size(); ++k)
    {
      const Id cell = ring.Cells[k];
      const int face = FaceAt(mesh, ring, k);
      const Id facet = mesh.Cell(cell).Facets[face];
      const bool onHull = IsHullFace(mesh, cell, face);
      if (facet != None || onHull)
      {
        around.Fans.push_back({ facet, { around.Before, ring.Points[k] }, false, {} });
        if (!FollowFan(mesh, around, onHull, around.Fans.back()))
        {
          return false;
        }
      }
    }
    return true;
  }
  for (const bool facetsOnly : { true, false })
  {
    for (std::size_t k = 0; k < around.Star.size() && around.Fans.empty(); ++k)
    {
      const Id id = around.Star[k];
      const FlippableCell& cell = mesh.Cell(id);
      const int corner = mesh.CornerIndex(id, around.Point);
      for (int face = 0; face < 4 && around.Fans.empty(); ++face)
      {
        const bool onHull = IsHullFace(mesh, id, face);
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
        around.Fans.push_back(fan);
        if (!FollowFan(mesh, around, onHull, around.Fans.back()))
        {
          return false;
        }
      }
    }
  }
  return true;
}

/**
 * Add free pairs of faces between the segment's two halves: cells beyond them need not be seen.
 * @return whether there is any
 */
bool AddSeparators(const FlippableMesh& mesh, Surroundings& around)
{
  const std::size_t fans = around.Fans.size();
  const EdgeRing before = RingTo(mesh, around.Point, around.Before);
  const EdgeRing behind = RingTo(mesh, around.Point, around.Behind);
  for (const Id p : before.Points)
  {
    const bool isTaken = std::any_of(around.Fans.begin(), around.Fans.end(),
      [p](const Fan& fan)
      { return std::find(fan.Points.begin(), fan.Points.end(), p) != fan.Points.end(); });
    if (!isTaken && p != mesh.Infinite() &&
      std::find(behind.Points.begin(), behind.Points.end(), p) != behind.Points.end())
    {
      around.Fans.push_back({ None, { around.Before, p, around.Behind }, false, {} });
    }
  }
  return around.Fans.size() > fans;
}

bool IsWall(const FlippableMesh& mesh, const Surroundings& around, Id cell, int face)
{
  if (mesh.Cell(cell).Facets[face] != None || IsHullFace(mesh, cell, face))
  {
    return true;
  }
  // A face between the two halves of a separator.
  if (around.Segment == None)
  {
    return false;
  }
  Id third = None;
  bool onSegment = false;
  for (int k = 0; k < 4; ++k)
  {
    const Id corner = mesh.Cell(cell).Corners[k];
    if (k == face || corner == around.Point)
    {
      continue;
    }
    if (corner == around.Before || corner == around.Behind)
    {
      onSegment = true;
    }
    else
    {
      third = corner;
    }
  }
  return onSegment &&
    std::any_of(around.Fans.begin(), around.Fans.end(),
      [&](const Fan& fan) { return fan.Points.size() == 3 && fan.Points[1] == third; });
}

// --- Triangulating facets without the point ------------------------------------------------------

bool CutEars(const ExactVertices& vertices, Id off, int side, Fan& fan, int start)
{
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

bool TriangulateFans(const FlippableMesh& mesh, Surroundings& around, int way)
{
  const ExactVertices& vertices = mesh.Vertices();
  const Id point = around.Point;
  for (Fan& fan : around.Fans)
  {
    fan.Pieces.clear();
    const Id off = mesh.VertexOffPlane(point, fan.Points[0], fan.Points[1]);
    if (off == None)
    {
      return false;
    }
    const int side = vertices.Orient(point, fan.Points[0], fan.Points[1], off);
    const std::size_t n = fan.Points.size();
    const bool isFlat = std::all_of(fan.Points.begin(), fan.Points.end(),
      [&](Id p) { return vertices.Orient(point, fan.Points[0], fan.Points[1], p) == 0; });
    if (n < 3 || !isFlat)
    {
      return false;
    }
    if (way == WaysToTriangulate - 1 || fan.IsClosed)
    {
      if (!CutEars(vertices, off, side, fan, way))
      {
        return false;
      }
      continue;
    }
    const std::size_t center = way == 0 ? 0 : n - 1;
    for (std::size_t k = way == 0 ? 1 : 0; k + (way == 0 ? 1 : 2) < n; ++k)
    {
      const Triangle piece = { { fan.Points[k], fan.Points[k + 1], fan.Points[center] } };
      if (side * vertices.Orient(piece[0], piece[1], piece[2], off) <= 0)
      {
        return false;
      }
      fan.Pieces.push_back(piece);
    }
  }
  return true;
}

// --- Sectors -------------------------------------------------------------------------------------

/** The cell's face across from the point becomes a wall. */
void AddOuterWall(const FlippableMesh& mesh, Id point, Id cell, Sector& sector)
{
  if (!sector.IsInfinite)
  {
    const Triangle wall = mesh.FaceCorners(cell, mesh.CornerIndex(cell, point));
    sector.Walls.push_back(wall);
    sector.Corners.insert(sector.Corners.end(), wall.begin(), wall.end());
  }
}

/** Each fan becomes a wall of the sectors on its two sides, which must differ. */
bool AddFanWalls(const FlippableMesh& mesh, const std::vector<Id>& sectorOf, Surroundings& around)
{
  for (const Fan& fan : around.Fans)
  {
    Id cell;
    int face;
    if (!mesh.FindFace(around.Point, fan.Points[0], fan.Points[1], cell, face))
    {
      return false;
    }
    const Id other = mesh.Cell(cell).Neighbors[face];
    if (sectorOf[cell] == sectorOf[other])
    {
      return false;
    }
    for (const Id side : { cell, other })
    {
      const bool even = IsEven(mesh, side, around.Point, fan.Points[0], fan.Points[1]);
      for (Triangle piece : fan.Pieces)
      {
        if (!even)
        {
          std::swap(piece[0], piece[1]);
        }
        around.Sectors[sectorOf[side]].Walls.push_back(piece);
      }
    }
  }
  return true;
}

bool FindSectors(ExactState& state, Surroundings& around)
{
  const FlippableMesh& mesh = state.Mesh;
  std::vector<Id>& sectorOf = state.Scratch.SectorOf; // valid for cells of the star only
  around.Sectors.clear();
  sectorOf.resize(static_cast<std::size_t>(mesh.NumberOfCells()));
  for (const Id cell : around.Star)
  {
    sectorOf[cell] = None;
  }
  std::vector<Id> cells;
  for (const Id seed : around.Star)
  {
    if (sectorOf[seed] != None)
    {
      continue;
    }
    const Id number = static_cast<Id>(around.Sectors.size());
    around.Sectors.emplace_back();
    Sector& sector = around.Sectors.back();
    sector.IsInfinite = mesh.IsInfinite(seed);
    sectorOf[seed] = number;
    cells.assign(1, seed);
    for (std::size_t next = 0; next < cells.size(); ++next)
    {
      const FlippableCell& cell = mesh.Cell(cells[next]);
      AddOuterWall(mesh, around.Point, cells[next], sector);
      for (int k = 0; k < 4; ++k)
      {
        const Id neighbor = cell.Neighbors[k];
        if (cell.Corners[k] != around.Point && sectorOf[neighbor] == None &&
          !IsWall(mesh, around, cells[next], k))
        {
          sectorOf[neighbor] = number;
          cells.push_back(neighbor);
        }
      }
    }
    SortUniquely(sector.Corners);
  }
  return AddFanWalls(mesh, sectorOf, around);
}

bool Fill(ExactState& state, Surroundings& around, VolumePoints volumePoints)
{
  FlippableMesh& mesh = state.Mesh;
  // If only the segment itself has to stay, it does so when all cells meet in one of its ends.
  if (around.Fans.empty())
  {
    volumePoints = VolumePoints::None;
    if (around.Segment != None)
    {
      around.Sectors[0].Corners = { around.Before, around.Behind };
    }
  }
  std::vector<Tetrahedron> fresh;
  const Point inside = mesh.Vertices().Nearest(around.Point);
  if (!FillSectors(mesh, around.Sectors, inside, volumePoints, fresh))
  {
    return false;
  }
  mesh.Replace(around.Star, fresh);
  for (const Fan& fan : around.Fans)
  {
    for (const Triangle& piece : fan.Pieces)
    {
      mesh.MarkFace(piece[0], piece[1], piece[2], fan.Facet);
    }
  }
  if (around.Segment != None)
  {
    state.Segments.Join(around.Segment, around.Point);
  }
  return true;
}
} // namespace

bool DissolvePoint(ExactState& state, Id point, VolumePoints volumePoints)
{
  Surroundings around = {};
  around.Point = point;
  if (!FindStar(state, around))
  {
    return false;
  }
  for (const bool separate : { false, true })
  {
    if ((separate && around.Segment == None) || !FindFans(state.Mesh, around) ||
      (separate && !AddSeparators(state.Mesh, around)))
    {
      return false;
    }
    const bool oneWay = std::all_of(around.Fans.begin(), around.Fans.end(),
      [](const Fan& fan) { return fan.Points.size() <= 3; });
    for (int way = 0; way < (oneWay ? 1 : WaysToTriangulate); ++way)
    {
      if (TriangulateFans(state.Mesh, around, way) && FindSectors(state, around) &&
        Fill(state, around, volumePoints))
      {
        return true;
      }
    }
  }
  return false;
}
} // namespace insideout
