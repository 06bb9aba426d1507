// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/ExactState.h"

#include "Common/SortUniquely.h"

#include <utility>

namespace insideout
{
namespace
{
/** The mesh of points; facets are renumbered to the vertices that represent their corners. */
FlippableMesh DelaunayMeshOf(const std::vector<Point>& points, std::vector<Triangle>& facets,
  WorkBudget& work, Monitor& monitor)
{
  std::vector<Id> same;
  FlippableMesh mesh(points, same, work, monitor);
  for (Triangle& facet : facets)
  {
    facet = { { same[facet[0]], same[facet[1]], same[facet[2]] } };
  }
  return mesh;
}
} // namespace

ExactState::ExactState(const std::vector<Point>& points, std::vector<Triangle> facets,
  WorkBudget& work, Monitor& monitor)
  : Mesh(DelaunayMeshOf(points, facets, work, monitor))
  , Facets(std::move(facets))
  , Segments(this->Facets)
  , Progress(&monitor)
{
}

ExactState::ExactState(FlippableMesh mesh, std::vector<Triangle> facets, Monitor& monitor)
  : Mesh(std::move(mesh))
  , Facets(std::move(facets))
  , Segments(this->Facets)
  , Progress(&monitor)
{
}

std::vector<bool> ExactState::FacetsThatAreThere() const
{
  std::vector<bool> areThere(this->Facets.size(), false);
  this->Mesh.VisitFacets([&](Id cell, int k) { areThere[this->Mesh.Cell(cell).Facets[k]] = true; });
  return areThere;
}

std::vector<Id> ExactState::SegmentsOf(const std::vector<Id>& facets) const
{
  std::vector<Id> segments;
  for (const Id facet : facets)
  {
    for (int k = 0; k < 3; ++k)
    {
      segments.push_back(this->Segments.OfFacet(facet, k));
    }
  }
  SortUniquely(segments);
  return segments;
}

std::vector<Id> ExactState::SteinerPoints(std::int64_t since) const
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

PointSupport ExactState::SupportOf(Id point) const
{
  PointSupport support;
  support.Segment = this->Segments.Around(point);
  std::vector<Id> star;
  this->Mesh.Star(point, star);
  for (const Id id : star)
  {
    const FlippableCell& cell = this->Mesh.Cell(id);
    for (int k = 0; k < 4; ++k)
    {
      if (cell.Corners[k] != point && cell.Facets[k] != None)
      {
        support.Facets.push_back(cell.Facets[k]);
      }
    }
  }
  SortUniquely(support.Facets);
  return support;
}

std::set<Id> ExactState::FacetsAround(const std::vector<Id>& points, int rings) const
{
  std::vector<Id> cells;
  std::set<Id> facets;
  for (const Id point : points)
  {
    const std::vector<Id> own = this->SupportOf(point).Facets;
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

void ExactState::LetGo(const std::set<Id>& facets)
{
  this->Mesh.VisitFacets(
    [&](Id cell, int k)
    {
      if (facets.count(this->Mesh.Cell(cell).Facets[k]) > 0)
      {
        this->Mesh.SetFacet(cell, k, None);
        for (const Id corner : this->Mesh.FaceCorners(cell, k))
        {
          this->Mesh.Touch(corner);
        }
      }
    });
  std::vector<bool> isUsed(static_cast<std::size_t>(this->Segments.Size()), false);
  const std::vector<bool> areThere = this->FacetsThatAreThere();
  for (Id facet = 0; facet < static_cast<Id>(this->Facets.size()); ++facet)
  {
    for (int k = 0; areThere[facet] && k < 3; ++k)
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
