// SPDX-License-Identifier: GPL-3.0-or-later
#include "Layers/LayerWall.h"

#include "Common/Edge.h"
#include "Common/SortUniquely.h"

#include <utility>

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
} // namespace insideout
