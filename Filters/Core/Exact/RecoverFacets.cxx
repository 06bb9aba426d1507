// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/RecoverFacets.h"

#include "Exact/EngineLimits.h"
#include "Exact/Phases.h"

#include <algorithm>
#include <set>
#include <utility>

namespace insideout
{
namespace
{
/** How often the monitor is asked. */
constexpr std::size_t FacetsPerCheck = 4;
} // namespace

std::vector<FacetRecovery::MeshEdge> FacetRecovery::BoundaryOf(Id facet) const
{
  std::vector<MeshEdge> edges;
  const Triangle& corners = this->Facets[facet];
  for (int k = 0; k < 3; ++k)
  {
    std::vector<Id> path = this->Segments.Path(this->Segments.OfFacet(facet, k));
    if (path.front() != corners[k])
    {
      std::reverse(path.begin(), path.end());
    }
    for (std::size_t j = 1; j < path.size(); ++j)
    {
      edges.push_back({ path[j - 1], path[j] });
    }
  }
  return edges;
}

/**
 * The face on the facet to the left of the edge from x to y, or the edge that passes through there.
 * @param[in] off a vertex off the facet's plane
 */
FacetRecovery::Search FacetRecovery::FaceBeside(
  Id facet, Id x, Id y, Id off, MeshFace& face, Id& apex, MeshEdge& crossing) const
{
  const ExactVertices& vertices = this->Mesh.Vertices();
  const Triangle& corners = this->Facets[facet];
  const Id cell = this->Mesh.FindEdge(x, y);
  if (cell == None)
  {
    return Search::Impossible;
  }
  EdgeRing ring;
  this->Mesh.Ring(x, y, cell, ring);
  const std::size_t n = ring.Points.size();
  const int side = vertices.Orient(corners[0], corners[1], corners[2], off);
  for (std::size_t k = 0; k < n; ++k)
  {
    const Id p = ring.Points[k];
    if (p != this->Mesh.Infinite() && vertices.Orient(corners[0], corners[1], corners[2], p) == 0 &&
      vertices.Orient(x, y, p, off) == side)
    {
      apex = p;
      face = { ring.Cells[k], this->Mesh.CornerIndex(ring.Cells[k], ring.Points[(k + 1) % n]) };
      return Search::Found;
    }
  }
  const auto inner = std::find_if(corners.begin(), corners.end(),
    [&](Id corner) { return vertices.Orient(x, y, corner, off) == side; });
  for (std::size_t k = 0; inner != corners.end() && k < n; ++k)
  {
    const Id p = ring.Points[k];
    const Id q = ring.Points[(k + 1) % n];
    if (p != this->Mesh.Infinite() && q != this->Mesh.Infinite() &&
      vertices.Orient(x, y, p, *inner) > 0 && vertices.Orient(x, y, *inner, q) > 0)
    {
      crossing = { p, q };
      return Search::Crossed;
    }
  }
  return Search::Impossible;
}

/** From the facet's boundary inward, face by face. */
FacetRecovery::Search FacetRecovery::FindFaces(
  Id facet, std::vector<MeshFace>& faces, MeshEdge& crossing) const
{
  const Triangle& corners = this->Facets[facet];
  faces.clear();
  MeshFace whole;
  if (this->Mesh.FindFace(corners[0], corners[1], corners[2], whole.Cell, whole.Face))
  {
    faces.push_back(whole);
    return Search::Found;
  }
  const Id off = this->Mesh.VertexOffPlane(corners[0], corners[1], corners[2]);
  if (off == None)
  {
    return Search::Impossible;
  }
  std::vector<MeshEdge> open = this->BoundaryOf(facet);
  std::set<std::pair<Id, Id>> boundary;
  for (const MeshEdge& edge : open)
  {
    boundary.insert({ edge.U, edge.V });
  }
  std::set<std::pair<Id, Id>> done;
  while (!open.empty())
  {
    const MeshEdge edge = open.back();
    open.pop_back();
    if (done.count({ edge.U, edge.V }))
    {
      continue;
    }
    MeshFace face;
    Id apex = None;
    const Search search = this->FaceBeside(facet, edge.U, edge.V, off, face, apex, crossing);
    if (search != Search::Found)
    {
      return search;
    }
    faces.push_back(face);
    done.insert({ edge.U, edge.V });
    for (const MeshEdge& next : { MeshEdge{ edge.V, apex }, MeshEdge{ apex, edge.U } })
    {
      done.insert({ next.U, next.V });
      if (!boundary.count({ next.U, next.V }))
      {
        open.push_back({ next.V, next.U });
      }
    }
  }
  return Search::Found;
}

void FacetRecovery::Mark(Id facet, const std::vector<MeshFace>& faces)
{
  for (const MeshFace& face : faces)
  {
    this->Mesh.SetFacet(face.Cell, face.Face, facet);
  }
}

std::vector<Id> FacetRecovery::MarkWholeFacets(const std::vector<Id>& facets)
{
  std::vector<Triangle> triangles;
  triangles.reserve(facets.size());
  for (const Id facet : facets)
  {
    triangles.push_back(this->Facets[facet]);
  }
  const std::vector<MeshFace> faces = this->Mesh.FindFaces(triangles);
  std::vector<Id> others;
  for (std::size_t i = 0; i < facets.size(); ++i)
  {
    // A face beside a Steiner point that was rounded off the facet's edge is not the facet.
    bool isSplit = false;
    for (int k = 0; k < 3; ++k)
    {
      isSplit = isSplit || this->Segments.IsSplit(this->Segments.OfFacet(facets[i], k));
    }
    if (faces[i].Cell != None && !isSplit)
    {
      this->Mark(facets[i], { faces[i] });
    }
    else
    {
      others.push_back(facets[i]);
    }
  }
  return others;
}

/** All edges that cross the facet and hang together with `first` through cells. */
std::vector<FacetRecovery::MeshEdge> FacetRecovery::AllCrossings(
  Id facet, const MeshEdge& first) const
{
  const FlipTarget target = FlipTarget::Facet(this->Mesh, this->Facets[facet]);
  std::vector<MeshEdge> edges(1, first);
  std::set<std::pair<Id, Id>> known = { std::minmax(first.U, first.V) };
  EdgeRing ring;
  for (std::size_t next = 0; next < edges.size(); ++next)
  {
    const MeshEdge edge = edges[next];
    this->Mesh.Ring(edge.U, edge.V, this->Mesh.FindEdge(edge.U, edge.V), ring);
    for (const Id p : ring.Points)
    {
      for (const Id end : { edge.U, edge.V })
      {
        if (target.CostOfEdge(end, p) > 0 && known.insert(std::minmax(end, p)).second)
        {
          edges.push_back({ end, p });
        }
      }
    }
    for (std::size_t k = 0; k < ring.Points.size(); ++k)
    {
      const Id p = ring.Points[k];
      const Id q = ring.Points[(k + 1) % ring.Points.size()];
      if (target.CostOfEdge(p, q) > 0 && known.insert(std::minmax(p, q)).second)
      {
        edges.push_back({ p, q });
      }
    }
  }
  return edges;
}

bool FacetRecovery::Recover(Id facet, const FlipEffort& effort)
{
  const FlipTarget target = FlipTarget::Facet(this->Mesh, this->Facets[facet]);
  std::vector<MeshFace> faces;
  MeshEdge first;
  for (int pass = 0; pass < EngineLimits::PassesPerFacet; ++pass)
  {
    this->Progress.Check(Phases::RecoveringFacets, 0);
    const Search search = this->FindFaces(facet, faces, first);
    if (search == Search::Found)
    {
      this->Mark(facet, faces);
      return true;
    }
    if (search == Search::Impossible)
    {
      return false;
    }
    const std::int64_t before = this->Mesh.NumberOfChanges();
    for (const MeshEdge& crossing : this->AllCrossings(facet, first))
    {
      if (this->Mesh.Work().Spent() > effort.EndOfWork)
      {
        return false;
      }
      int budget = effort.Budget;
      this->Flips.RemoveEdgeDeeply(
        crossing.U, crossing.V, target, effort.Limits, effort.Depth, budget);
    }
    if (this->Mesh.NumberOfChanges() == before)
    {
      return false;
    }
  }
  return false;
}

std::vector<Id> FacetRecovery::RecoverByFlips(const std::vector<Id>& missing)
{
  return RecoverInRounds(missing, this->Mesh,
    static_cast<std::int64_t>(this->Mesh.Infinite()) +
      static_cast<std::int64_t>(this->Facets.size()),
    this->Progress, Phases::RecoveringFacets,
    [this](Id facet, const FlipEffort& effort) { return this->Recover(facet, effort); });
}

/** Put a point where the edge passes through the facet's plane, if it does. */
bool FacetRecovery::SplitOnFacet(Id facet, const MeshEdge& edge)
{
  const Triangle& f = this->Facets[facet];
  const DyadicNumber atU = this->Mesh.Vertices().Determinant(f[0], f[1], f[2], edge.U);
  const DyadicNumber atV = this->Mesh.Vertices().Determinant(f[0], f[1], f[2], edge.V);
  const Id cell = this->Mesh.FindEdge(edge.U, edge.V);
  if (cell == None || atU.sign() * atV.sign() >= 0)
  {
    return false;
  }
  const Id point = this->Mesh.AddVertexBetween(edge.U, edge.V, DyadicNumber(0) - atV, atU, f);
  EdgeRing ring;
  this->Mesh.Ring(edge.U, edge.V, cell, ring);
  this->Mesh.SplitEdge(ring, point);
  return true;
}

std::vector<Id> FacetRecovery::RecoverBySplits(
  const std::vector<Id>& missing, SteinerPoints& steiner)
{
  std::vector<Id> failed;
  std::vector<MeshFace> faces;
  MeshEdge crossing;
  for (std::size_t k = 0; k < missing.size(); ++k)
  {
    if (k % FacetsPerCheck == 0)
    {
      this->Progress.Check(Phases::SplittingFacets, static_cast<double>(k) / missing.size());
    }
    const Id first = this->Mesh.Vertices().Size();
    const Id facet = missing[k];
    Search search = this->FindFaces(facet, faces, crossing);
    while (search == Search::Crossed && !this->Mesh.Work().IsUsedUp())
    {
      // None of the edges that cross the facet goes because of the others' points, and none comes.
      const std::vector<MeshEdge> crossings = this->AllCrossings(facet, crossing);
      for (const MeshEdge& edge : crossings)
      {
        if (!this->SplitOnFacet(facet, edge))
        {
          search = Search::Impossible;
          break;
        }
      }
      if (search == Search::Crossed)
      {
        this->Progress.Check(Phases::SplittingFacets, static_cast<double>(k) / missing.size());
        search = this->FindFaces(facet, faces, crossing);
      }
    }
    if (search == Search::Found)
    {
      this->Mark(facet, faces);
    }
    else
    {
      failed.push_back(facet);
    }
    steiner.Tidy(first);
  }
  return failed;
}
} // namespace insideout
