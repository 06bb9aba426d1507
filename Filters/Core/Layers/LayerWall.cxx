// SPDX-License-Identifier: GPL-3.0-or-later
#include "Layers/LayerWall.h"

#include "Common/Edge.h"
#include "Common/SortUniquely.h"
#include "Common/SortedTriangle.h"

#include <algorithm>

namespace insideout
{
LayerWall::LayerWall(std::size_t points, std::vector<Triangle> triangles)
  : Triangles(std::move(triangles))
{
  std::vector<Edge> edges;
  for (const Triangle& triangle : this->Triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->Points.push_back(triangle[k]);
      edges.push_back(EdgeBetween(triangle[k], triangle[(k + 1) % 3]));
    }
  }
  SortUniquely(this->Points);
  SortUniquely(edges);
  this->TrianglesAt = Buckets<Id>(points,
    [&](auto visit)
    {
      for (std::size_t t = 0; t < this->Triangles.size(); ++t)
      {
        for (const Id corner : this->Triangles[t])
        {
          visit(static_cast<std::size_t>(corner), static_cast<Id>(t));
        }
      }
    });
  this->NeighborsOf = Buckets<Id>(points,
    [&](auto visit)
    {
      for (const Edge& edge : edges)
      {
        visit(static_cast<std::size_t>(edge[0]), edge[1]);
        visit(static_cast<std::size_t>(edge[1]), edge[0]);
      }
    });
}

std::vector<char> HeldPoints(
  const RefinableMesh& mesh, const RefinableSurface& surface, const LayerWall& wall)
{
  std::vector<Triangle> sorted;
  for (const Triangle& triangle : wall.Triangles)
  {
    sorted.push_back(SortedTriangle(triangle).Points);
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<char> isHeld(mesh.Points.size(), 0);
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    const RefinableCell& cell = mesh.Cell(c);
    for (int k = 0; k < 4; ++k)
    {
      const Triangle face = FaceAcross(cell.Corners, k);
      const bool isWall = cell.Neighbors[k] == None &&
        std::binary_search(sorted.begin(), sorted.end(), SortedTriangle(face).Points);
      for (const Id corner : face)
      {
        isHeld[corner] |= cell.Facets[k] != None && !isWall ? 1 : 0;
      }
    }
  }
  for (const Id point : wall.Points)
  {
    isHeld[point] |= surface.IsPinched(point) ? 1 : 0;
  }
  return isHeld;
}
} // namespace insideout
