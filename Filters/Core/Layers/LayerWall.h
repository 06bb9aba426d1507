// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Buckets.h"
#include "Common/Edge.h"
#include "Common/SortUniquely.h"
#include "Common/Types.h"

#include <utility>
#include <vector>

namespace insideout
{
/** The points of a wall and what is around them: facets are triangles in space, edges in a plane.
 */
struct WallPoints
{
  /** @param[in] points of the mesh */
  template <std::size_t Corners>
  WallPoints(std::size_t points, const std::vector<std::array<Id, Corners>>& facets);

  std::vector<Id> Points;  ///< of the facets, ascending
  Buckets<Id> FacetsAt;    ///< per point of the mesh
  Buckets<Id> NeighborsOf; ///< per point of the mesh, those that share an edge of the wall
};

/** The triangles of a boundary that get layers, and their points. */
struct LayerWall : WallPoints
{
  /** @param[in] points of the mesh; @param[in] triangles as Triangles has them */
  LayerWall(std::size_t points, std::vector<Triangle> triangles)
    : WallPoints(points, triangles)
    , Triangles(std::move(triangles))
  {
  }

  std::vector<Triangle> Triangles; ///< counter-clockwise seen from outside
};

template <std::size_t Corners>
WallPoints::WallPoints(std::size_t points, const std::vector<std::array<Id, Corners>>& facets)
{
  std::vector<Edge> edges;
  for (const auto& facet : facets)
  {
    for (std::size_t k = 0; k < Corners; ++k)
    {
      this->Points.push_back(facet[k]);
      edges.push_back(EdgeBetween(facet[k], facet[(k + 1) % Corners]));
    }
  }
  SortUniquely(this->Points);
  SortUniquely(edges);
  this->FacetsAt = Buckets<Id>(points,
    [&](auto visit)
    {
      for (std::size_t f = 0; f < facets.size(); ++f)
      {
        for (const Id corner : facets[f])
        {
          visit(static_cast<std::size_t>(corner), static_cast<Id>(f));
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
