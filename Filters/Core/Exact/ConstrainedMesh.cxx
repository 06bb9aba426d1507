// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/ConstrainedMesh.h"

#include "Exact/PointSupport.h"
#include "Exact/RecoverFacets.h"

namespace insideout
{
namespace
{
/** The facets between the vertices that stand for points. */
std::vector<Triangle> Renamed(std::vector<Triangle> facets, const std::vector<Id>& same)
{
  for (Triangle& facet : facets)
  {
    for (Id& corner : facet)
    {
      corner = same[corner];
    }
  }
  return facets;
}
} // namespace

ConstrainedMesh::ConstrainedMesh(const std::vector<Point>& points,
  const std::vector<Triangle>& facets, WorkBudget& work, Monitor& monitor)
  : ConstrainedMesh(points, facets, {}, work, monitor)
{
}

ConstrainedMesh::ConstrainedMesh(const std::vector<Point>& points,
  const std::vector<Triangle>& facets, std::vector<Id> same, WorkBudget& work, Monitor& monitor)
  : Mesh(points, same, work, monitor)
  , Facets(Renamed(facets, same))
  , Segments(this->Facets)
{
}

std::vector<bool> ConstrainedMesh::AreThere() const
{
  std::vector<bool> isThere(this->Facets.size(), false);
  for (Id cell = 0; cell < this->Mesh.NumberOfCells(); ++cell)
  {
    for (int k = 0; !this->Mesh.IsDead(cell) && k < 4; ++k)
    {
      if (this->Mesh.Cell(cell).Facets[k] != None)
      {
        isThere[this->Mesh.Cell(cell).Facets[k]] = true;
      }
    }
  }
  return isThere;
}

std::vector<Id> ConstrainedMesh::FindLost(Monitor& monitor)
{
  const std::vector<bool> isThere = this->AreThere();
  std::vector<Id> lost;
  for (Id facet = 0; facet < static_cast<Id>(this->Facets.size()); ++facet)
  {
    if (!isThere[facet])
    {
      lost.push_back(facet);
    }
  }
  return FacetRecovery(this->Mesh, this->Segments, this->Facets, monitor).MarkWholeFacets(lost);
}

std::vector<Id> ConstrainedMesh::SegmentsOf(const std::vector<Id>& facets) const
{
  std::set<Id> segments;
  for (const Id facet : facets)
  {
    for (int k = 0; k < 3; ++k)
    {
      segments.insert(this->Segments.OfFacet(facet, k));
    }
  }
  return { segments.begin(), segments.end() };
}

std::vector<Id> ConstrainedMesh::SteinerPoints(std::int64_t since) const
{
  std::vector<Id> points;
  for (Id vertex = this->Mesh.Infinite() + 1; vertex < this->Mesh.Vertices().Size(); ++vertex)
  {
    if (this->Mesh.HasVertex(vertex) && this->Mesh.LastChangeAround(vertex) > since)
    {
      points.push_back(vertex);
    }
  }
  return points;
}

std::set<Id> ConstrainedMesh::FacetsAround(const std::vector<Id>& points, int rings) const
{
  std::vector<Id> cells;
  std::set<Id> facets;
  for (const Id point : points)
  {
    const std::vector<Id> own = FindPointSupport(this->Mesh, this->Segments, point).Facets;
    facets.insert(own.begin(), own.end());
    this->Mesh.Star(point, cells);
  }
  for (int ring = 0; ring < rings; ++ring)
  {
    std::set<Id> known(cells.begin(), cells.end());
    for (const Id id : std::vector<Id>(cells))
    {
      const FlippableCell& cell = this->Mesh.Cell(id);
      for (int k = 0; k < 4; ++k)
      {
        if (cell.Facets[k] != None)
        {
          facets.insert(cell.Facets[k]);
        }
        if (known.insert(cell.Neighbors[k]).second)
        {
          cells.push_back(cell.Neighbors[k]);
        }
      }
    }
  }
  return facets;
}

void ConstrainedMesh::LetGo(const std::set<Id>& facets)
{
  for (Id cell = 0; cell < this->Mesh.NumberOfCells(); ++cell)
  {
    for (int k = 0; !this->Mesh.IsDead(cell) && k < 4; ++k)
    {
      if (facets.count(this->Mesh.Cell(cell).Facets[k]) > 0)
      {
        this->Mesh.SetFacet(cell, k, None);
        for (const Id corner : this->Mesh.FaceCorners(cell, k))
        {
          this->Mesh.Touch(corner);
        }
      }
    }
  }
  std::vector<bool> isUsed(static_cast<std::size_t>(this->Segments.Size()), false);
  const std::vector<bool> isThere = this->AreThere();
  for (Id facet = 0; facet < static_cast<Id>(this->Facets.size()); ++facet)
  {
    for (int k = 0; isThere[facet] && k < 3; ++k)
    {
      isUsed[this->Segments.OfFacet(facet, k)] = true;
    }
  }
  for (Id segment = 0; segment < this->Segments.Size(); ++segment)
  {
    if (!isUsed[segment])
    {
      this->Segments.Release(segment);
    }
  }
}
} // namespace insideout
