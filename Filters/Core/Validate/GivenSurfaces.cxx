// SPDX-License-Identifier: GPL-3.0-or-later
#include "Validate/GivenSurfaces.h"

#include "Common/DisjointSets.h"

#include <algorithm>

namespace insideout
{
namespace
{
/** An edge of a facet, and whether the facet runs along it. */
struct RunAlong
{
  Id Edge;
  int Direction;
};

std::vector<std::array<RunAlong, 3>> EdgesOfFacets(
  Id facets, const FacetEdges& edges, Id& numberOfEdges)
{
  std::vector<std::array<RunAlong, 3>> found(facets);
  std::vector<char> size(facets, 0);
  numberOfEdges = 0;
  ForEachEdge(edges,
    [&](const FacetEdge* first, const FacetEdge* last)
    {
      for (const FacetEdge* edge = first; edge != last; ++edge)
      {
        found[edge->Facet][size[edge->Facet]++] = { numberOfEdges, edge->Direction };
      }
      ++numberOfEdges;
    });
  return found;
}

/** Numbers the closed runs of triangles in the given order. */
class ClosedRuns
{
public:
  ClosedRuns(const FacetComplex& surface, const FacetEdges& edges)
    : Edges(EdgesOfFacets(surface.NumberOfFacets(), edges, this->NumberOfEdges))
    , SumOfEdge(this->NumberOfEdges, 0)
    , OfFacet(surface.Facets.size())
  {
  }

  /** Add the next triangle. @return its run */
  Id Add(Id facet, bool reversed)
  {
    const Id run = this->Ended;
    InRun& sum = this->OfFacet[facet];
    sum = sum.Run == run ? sum : InRun{ run, 0 };
    this->Uncancelled -= sum.Count != 0;
    sum.Count += reversed ? -1 : 1;
    this->Uncancelled += sum.Count != 0;
    for (const RunAlong& along : this->Edges[facet])
    {
      Id& ofEdge = this->SumOfEdge[along.Edge];
      this->OpenEdges -= ofEdge != 0;
      ofEdge += reversed ? -along.Direction : along.Direction;
      this->OpenEdges += ofEdge != 0;
    }
    if (this->OpenEdges == 0 && this->Uncancelled > 0)
    {
      ++this->Ended;
      this->Uncancelled = 0;
    }
    return run;
  }

  Id NumberOfEnded() const { return this->Ended; }

private:
  struct InRun
  {
    Id Run = None;
    Id Count = 0;
  };

  Id NumberOfEdges = 0;
  std::vector<std::array<RunAlong, 3>> Edges; // per facet
  std::vector<Id> SumOfEdge;                  // of all triangles so far
  std::vector<InRun> OfFacet;
  Id OpenEdges = 0;
  Id Uncancelled = 0; // facets of this run
  Id Ended = 0;
};

/** Replace surfaces that are not closed by None. */
void KeepClosed(const FacetComplex& surface, const FacetEdges& edges, std::vector<Id>& given)
{
  std::vector<char> isOpen(
    given.empty() ? 0 : static_cast<std::size_t>(*std::max_element(given.begin(), given.end())) + 1,
    0);
  std::vector<std::array<Id, 2>> runs; // surfaces at an edge, with the direction of their triangles
  ForEachEdge(edges,
    [&](const FacetEdge* first, const FacetEdge* last)
    {
      runs.clear();
      for (const FacetEdge* edge = first; edge != last; ++edge)
      {
        for (Id s = surface.SourceOffsets[edge->Facet]; s < surface.SourceOffsets[edge->Facet + 1];
             ++s)
        {
          runs.push_back(
            { given[s], surface.Sources[s].Reversed ? -edge->Direction : edge->Direction });
        }
      }
      std::sort(runs.begin(), runs.end());
      for (std::size_t i = 0; i < runs.size();)
      {
        const Id one = runs[i][0];
        Id sum = 0;
        for (; i < runs.size() && runs[i][0] == one; ++i)
        {
          sum += runs[i][1];
        }
        isOpen[one] |= sum != 0;
      }
    });
  for (Id& one : given)
  {
    one = isOpen[one] ? None : one;
  }
}

std::vector<Id> SurfacesByPoints(const TriangleSoup& soup, const FacetComplex& surface)
{
  DisjointSets given(soup.Points.size());
  for (const Triangle& triangle : soup.Triangles)
  {
    given.Join(triangle[0], triangle[1]);
    given.Join(triangle[0], triangle[2]);
  }
  std::vector<Id> found;
  found.reserve(surface.Sources.size());
  for (const FacetSource& source : surface.Sources)
  {
    found.push_back(given.Find(soup.Triangles[source.Triangle][0]));
  }
  return found;
}

/** Find the closed runs of triangles; triangles after the last one have None. */
std::vector<Id> SurfacesInOrder(
  const TriangleSoup& soup, const FacetComplex& surface, const FacetEdges& edges)
{
  struct Place
  {
    Id Facet = None;
    Id Source = None;
  };
  std::vector<Place> places(soup.Triangles.size());
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    for (Id s = surface.SourceOffsets[f]; s < surface.SourceOffsets[f + 1]; ++s)
    {
      places[surface.Sources[s].Triangle] = { f, s };
    }
  }
  ClosedRuns runs(surface, edges);
  std::vector<Id> given(surface.Sources.size());
  for (const auto& [facet, source] : places)
  {
    if (facet != None)
    {
      given[source] = runs.Add(facet, surface.Sources[source].Reversed);
    }
  }
  for (Id& one : given)
  {
    one = one < runs.NumberOfEnded() ? one : None;
  }
  return given;
}
} // namespace

std::vector<Id> FindGivenSurfaces(
  const TriangleSoup& soup, const FacetComplex& surface, const FacetEdges& edges)
{
  std::vector<Id> given = SurfacesInOrder(soup, surface, edges);
  const auto isOfFirst = [&](Id one) { return one == given.front(); };
  if (std::all_of(given.begin(), given.end(), isOfFirst))
  {
    given = SurfacesByPoints(soup, surface);
    KeepClosed(surface, edges, given);
  }
  return given;
}
} // namespace insideout
