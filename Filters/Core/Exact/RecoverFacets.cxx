// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/RecoverFacets.h"

#include "Common/Edge.h"
#include "Exact/Flips.h"
#include "Exact/Phases.h"
#include "Exact/SteinerPoints.h"

#include <algorithm>
#include <set>
#include <unordered_set>
#include <utility>

namespace insideout
{
namespace
{
/** From one vertex to another. */
using MeshEdge = std::pair<Id, Id>;

enum class Search
{
  Found,
  Crossed,
  Impossible
};

std::vector<MeshEdge> BoundaryOf(const ExactState& state, Id facet)
{
  std::vector<MeshEdge> edges;
  const Triangle& corners = state.Facets[facet];
  for (int k = 0; k < 3; ++k)
  {
    std::vector<Id> path = state.Segments.Path(state.Segments.OfFacet(facet, k));
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
 * The face on the facet to the left of the edge from x to y, or the edge that crosses the facet
 * there.
 * @param[in] off a vertex off the facet's plane
 */
Search FaceBeside(const FlippableMesh& mesh, const Triangle& corners, const MeshEdge& edge, Id off,
  MeshFace& face, Id& apex, MeshEdge& crossing)
{
  const Id x = edge.first;
  const Id y = edge.second;
  const ExactVertices& vertices = mesh.Vertices();
  const Id cell = mesh.FindEdge(x, y);
  if (cell == None)
  {
    return Search::Impossible;
  }
  EdgeRing ring;
  mesh.Ring(x, y, cell, ring);
  const std::size_t n = ring.Points.size();
  const int side = vertices.Orient(corners[0], corners[1], corners[2], off);
  for (std::size_t k = 0; k < n; ++k)
  {
    const Id p = ring.Points[k];
    if (p != mesh.Infinite() && vertices.Orient(corners[0], corners[1], corners[2], p) == 0 &&
      vertices.Orient(x, y, p, off) == side)
    {
      apex = p;
      face = { ring.Cells[k], mesh.CornerIndex(ring.Cells[k], ring.Points[(k + 1) % n]) };
      return Search::Found;
    }
  }
  const auto inner = std::find_if(corners.begin(), corners.end(),
    [&](Id corner) { return vertices.Orient(x, y, corner, off) == side; });
  for (std::size_t k = 0; inner != corners.end() && k < n; ++k)
  {
    const Id p = ring.Points[k];
    const Id q = ring.Points[(k + 1) % n];
    if (p != mesh.Infinite() && q != mesh.Infinite() && vertices.Orient(x, y, p, *inner) > 0 &&
      vertices.Orient(x, y, *inner, q) > 0)
    {
      crossing = { p, q };
      return Search::Crossed;
    }
  }
  return Search::Impossible;
}

/** Find faces from the facet's boundary inward. */
Search FindFaces(
  const ExactState& state, Id facet, std::vector<MeshFace>& faces, MeshEdge& crossing)
{
  const FlippableMesh& mesh = state.Mesh;
  const Triangle& corners = state.Facets[facet];
  faces.clear();
  MeshFace whole;
  if (mesh.FindFace(corners[0], corners[1], corners[2], whole.Cell, whole.Face))
  {
    faces.push_back(whole);
    return Search::Found;
  }
  const Id off = mesh.VertexOffPlane(corners[0], corners[1], corners[2]);
  if (off == None)
  {
    return Search::Impossible;
  }
  std::vector<MeshEdge> open = BoundaryOf(state, facet);
  const std::set<MeshEdge> boundary(open.begin(), open.end());
  std::set<MeshEdge> done;
  while (!open.empty())
  {
    const MeshEdge edge = open.back();
    open.pop_back();
    if (done.count(edge) > 0)
    {
      continue;
    }
    MeshFace face;
    Id apex = None;
    const Search search = FaceBeside(mesh, corners, edge, off, face, apex, crossing);
    if (search != Search::Found)
    {
      return search;
    }
    faces.push_back(face);
    done.insert(edge);
    for (const MeshEdge& next : { MeshEdge{ edge.second, apex }, MeshEdge{ apex, edge.first } })
    {
      done.insert(next);
      if (boundary.count(next) == 0)
      {
        open.emplace_back(next.second, next.first);
      }
    }
  }
  return Search::Found;
}

void Mark(FlippableMesh& mesh, Id facet, const std::vector<MeshFace>& faces)
{
  for (const MeshFace& face : faces)
  {
    mesh.SetFacet(face.Cell, face.Face, facet);
  }
}
} // namespace

std::vector<Id> MarkWholeFacets(ExactState& state, const std::vector<Id>& facets)
{
  std::vector<Triangle> triangles;
  triangles.reserve(facets.size());
  for (const Id facet : facets)
  {
    triangles.push_back(state.Facets[facet]);
  }
  const std::vector<MeshFace> faces = state.Mesh.FindFaces(triangles);
  std::vector<Id> others;
  for (std::size_t i = 0; i < facets.size(); ++i)
  {
    // A face beside a Steiner point that was rounded off the facet's edge is not the facet.
    bool isSplit = false;
    for (int k = 0; k < 3; ++k)
    {
      isSplit = isSplit || state.Segments.IsSplit(state.Segments.OfFacet(facets[i], k));
    }
    if (faces[i].Cell != None && !isSplit)
    {
      Mark(state.Mesh, facets[i], { faces[i] });
    }
    else
    {
      others.push_back(facets[i]);
    }
  }
  return others;
}

std::vector<Id> FindLostFacets(ExactState& state)
{
  const std::vector<bool> areThere = state.FacetsThatAreThere();
  std::vector<Id> lost;
  for (Id facet = 0; facet < static_cast<Id>(areThere.size()); ++facet)
  {
    if (!areThere[facet])
    {
      lost.push_back(facet);
    }
  }
  return MarkWholeFacets(state, lost);
}

namespace
{
/** Limit of passes over all edges that cross a facet: each pass leaves fewer edges, or others. */
constexpr int PassesPerFacet = 20;

/** Facets between two calls of the monitor. */
constexpr std::size_t FacetsPerCheck = 4;

/** All edges that cross the facet and are connected with `first` through cells. */
std::vector<MeshEdge> AllCrossings(
  const FlippableMesh& mesh, const FlipTarget& target, const MeshEdge& first)
{
  std::vector<MeshEdge> edges(1, first);
  std::vector<Id> cells(1, mesh.FindEdge(first.first, first.second)); // one at each edge
  std::unordered_set<Edge, HashOfEdge> known = { EdgeBetween(first.first, first.second) };
  const auto look = [&](Id x, Id y, Id cell)
  {
    if (known.insert(EdgeBetween(x, y)).second && target.CostOfEdge(x, y) > 0)
    {
      edges.push_back({ x, y });
      cells.push_back(cell);
    }
  };
  EdgeRing ring;
  for (std::size_t next = 0; next < edges.size(); ++next)
  {
    const auto [u, v] = edges[next];
    mesh.Ring(u, v, cells[next], ring);
    const std::size_t n = ring.Points.size();
    for (std::size_t k = 0; k < n; ++k)
    {
      look(u, ring.Points[k], ring.Cells[k]);
      look(v, ring.Points[k], ring.Cells[k]);
      look(ring.Points[k], ring.Points[(k + 1) % n], ring.Cells[k]);
    }
  }
  return edges;
}

bool Recover(ExactState& state, Id facet, const FlipEffort& effort)
{
  const FlippableMesh& mesh = state.Mesh;
  const FlipTarget target = FlipTarget::Facet(mesh, state.Facets[facet]);
  std::vector<MeshFace> faces;
  MeshEdge first;
  for (int pass = 0; pass < PassesPerFacet; ++pass)
  {
    state.Report(Phases::RecoveringFacets);
    const Search search = FindFaces(state, facet, faces, first);
    if (search == Search::Found)
    {
      Mark(state.Mesh, facet, faces);
      return true;
    }
    if (search == Search::Impossible || mesh.Work().Spent() > effort.EndOfWork)
    {
      return false;
    }
    const std::int64_t before = mesh.NumberOfChanges();
    for (const MeshEdge& crossing : AllCrossings(mesh, target, first))
    {
      if (mesh.Work().Spent() > effort.EndOfWork)
      {
        return false;
      }
      int budget = effort.Budget;
      RemoveEdgeDeeply(state, crossing.first, crossing.second, target, effort, budget);
    }
    if (mesh.NumberOfChanges() == before)
    {
      return false;
    }
  }
  return false;
}

/** Insert a point where the edge crosses the facet's plane, if it does. */
bool SplitOnFacet(FlippableMesh& mesh, const Triangle& f, const MeshEdge& edge)
{
  const auto [u, v] = edge;
  const DyadicNumber atU = mesh.Vertices().Determinant(f[0], f[1], f[2], u);
  const DyadicNumber atV = mesh.Vertices().Determinant(f[0], f[1], f[2], v);
  const Id cell = mesh.FindEdge(u, v);
  if (cell == None || atU.sign() * atV.sign() >= 0)
  {
    return false;
  }
  const Id point = mesh.AddVertexBetween(u, v, DyadicNumber(0) - atV, atU, f);
  EdgeRing ring;
  mesh.Ring(u, v, cell, ring);
  mesh.SplitEdge(ring, point);
  return true;
}
} // namespace

std::vector<Id> RecoverFacetsByFlips(ExactState& state, const std::vector<Id>& missing)
{
  return RecoverInRounds(state, missing, state.Facets.size(), Phases::RecoveringFacets,
    [&state](Id facet, const FlipEffort& effort) { return Recover(state, facet, effort); });
}

std::vector<Id> RecoverFacetsBySplits(ExactState& state, const std::vector<Id>& missing)
{
  std::vector<Id> failed;
  std::vector<MeshFace> faces;
  MeshEdge crossing;
  for (std::size_t k = 0; k < missing.size(); ++k)
  {
    const double fraction = static_cast<double>(k) / missing.size();
    if (k % FacetsPerCheck == 0)
    {
      state.Report(Phases::SplittingFacets, fraction);
    }
    const Id first = state.Mesh.Vertices().Size();
    const Id facet = missing[k];
    const FlipTarget target = FlipTarget::Facet(state.Mesh, state.Facets[facet]);
    Search search = FindFaces(state, facet, faces, crossing);
    while (search == Search::Crossed && !state.Mesh.Work().IsUsedUp())
    {
      // Splitting an edge at the facet neither removes another crossing edge nor creates one.
      const std::vector<MeshEdge> crossings = AllCrossings(state.Mesh, target, crossing);
      const bool isSplit = std::all_of(crossings.begin(), crossings.end(),
        [&](const MeshEdge& edge) { return SplitOnFacet(state.Mesh, state.Facets[facet], edge); });
      state.Report(Phases::SplittingFacets, fraction);
      search = isSplit ? FindFaces(state, facet, faces, crossing) : Search::Impossible;
    }
    if (search == Search::Found)
    {
      Mark(state.Mesh, facet, faces);
    }
    else
    {
      failed.push_back(facet);
    }
    Tidy(state, first);
  }
  return failed;
}
} // namespace insideout
