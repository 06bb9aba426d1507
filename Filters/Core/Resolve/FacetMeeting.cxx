// SPDX-License-Identifier: GPL-3.0-or-later
#include "Resolve/FacetMeeting.h"

#include "Common/SortUniquely.h"
#include "Common/TrianglePredicates.h"

#include <algorithm>

namespace insideout
{
namespace
{
/**
 * Add the intersections of corners and edges of `facet` with `other`, which is in another plane.
 */
void AddEnds(const FacetList& surface, Id facet, Id other, std::vector<ConstructedPoint>& ends)
{
  const FilteredTriangle corners = CornersOf(surface, facet);
  const FilteredTriangle triangle = CornersOf(surface, other);
  const std::array<int, 3> sides = SidesOfPlane(triangle, corners);
  const Triangle& ids = surface.Facets[facet];
  for (int k = 0; k < 3; ++k)
  {
    const int next = (k + 1) % 3;
    if (sides[k] == 0 && ContainsInPlane(triangle, corners[k]))
    {
      ends.push_back(ConstructedPoint::Corner(ids[k]));
    }
    else if (sides[k] * sides[next] < 0 && Pierces(corners[k], corners[next], triangle))
    {
      ends.push_back(ConstructedPoint::EdgeOnFacet({ { ids[k], ids[next] } }, other));
    }
  }
}

/** Add the corners of `facet` that lie in `other`, which is in the same plane. */
void AddCornersWithin(
  const FacetList& surface, Id facet, Id other, std::vector<ConstructedPoint>& ends)
{
  const FilteredTriangle triangle = CornersOf(surface, other);
  const FilteredTriangle corners = CornersOf(surface, facet);
  for (int k = 0; k < 3; ++k)
  {
    if (ContainsInPlane(triangle, corners[k]))
    {
      ends.push_back(ConstructedPoint::Corner(surface.Facets[facet][k]));
    }
  }
}

/** The ends of the part of an edge that lies in `other`, which is in the same plane. */
std::vector<ConstructedPoint> EndsWithin(
  const FacetList& surface, const std::array<Id, 2>& edge, Id other)
{
  const FilteredTriangle triangle = CornersOf(surface, other);
  const int axis = ProjectionAxis(triangle);
  const auto filtered = [&](Id p) { return ToFiltered(surface.Points[p]); };
  const auto side = [&](Id from, Id to, Id p)
  {
    return static_cast<int>(CGAL::orientation(
      Project(filtered(from), axis), Project(filtered(to), axis), Project(filtered(p), axis)));
  };
  std::vector<ConstructedPoint> ends;
  for (const Id p : edge)
  {
    if (ContainsInPlane(triangle, filtered(p)))
    {
      ends.push_back(ConstructedPoint::Corner(p));
    }
  }
  const Triangle& ids = surface.Facets[other];
  for (int k = 0; k < 3; ++k)
  {
    const Id from = ids[k];
    const Id to = ids[(k + 1) % 3];
    const int sideOfFrom = side(edge[0], edge[1], from);
    const int sideOfTo = side(edge[0], edge[1], to);
    if (side(from, to, edge[0]) * side(from, to, edge[1]) < 0 && sideOfFrom * sideOfTo <= 0)
    {
      ends.push_back(sideOfFrom == 0 ? ConstructedPoint::Corner(from)
          : sideOfTo == 0            ? ConstructedPoint::Corner(to)
                                     : ConstructedPoint::TwoEdges(edge, { { from, to } }, axis));
    }
  }
  return ends;
}
} // namespace

Meeting Meet(const FacetList& surface, Id a, Id b)
{
  const FilteredTriangle first = CornersOf(surface, a);
  const FilteredTriangle last = CornersOf(surface, b);
  const std::array<int, 3> sides = SidesOfPlane(first, last);
  Meeting meeting;
  meeting.InPlane = sides[0] == 0 && sides[1] == 0 && sides[2] == 0;
  if (meeting.InPlane && OverlapInPlane(first, last))
  {
    meeting.Overlap = true;
    return meeting;
  }
  std::vector<ConstructedPoint> ends;
  if (meeting.InPlane)
  {
    // The contact lies on an edge of each, so its ends are corners.
    AddCornersWithin(surface, a, b, ends);
    AddCornersWithin(surface, b, a, ends);
  }
  else
  {
    // Each end lies where an edge or corner of one facet meets the other facet.
    AddEnds(surface, a, b, ends);
    AddEnds(surface, b, a, ends);
  }
  const std::array<ConstructedPoint, 2> span = Span(surface, ends);
  meeting.First = span[0];
  meeting.Last = span[1];
  return meeting;
}

std::array<ConstructedPoint, 2> Span(
  const FacetList& surface, const std::vector<ConstructedPoint>& points)
{
  std::vector<ConstructedPoint> names = points;
  SortUniquely(names);
  if (names.size() <= 2)
  {
    return { names.front(), names.back() };
  }
  const Point origin = Nearest(names[0], surface);
  std::vector<LazyPoint> places;
  for (const ConstructedPoint& name : names)
  {
    places.emplace_back(name, surface, origin);
  }
  const auto before = [](const LazyPoint& p, const LazyPoint& q) { return Compare(p, q) < 0; };
  const auto ends = std::minmax_element(places.begin(), places.end(), before);
  return { ends.first->Name(), ends.second->Name() };
}

std::vector<std::array<ConstructedPoint, 2>> EdgesWithin(
  const FacetList& surface, Id facet, Id other)
{
  std::vector<std::array<ConstructedPoint, 2>> edges;
  const Triangle& ids = surface.Facets[facet];
  for (int k = 0; k < 3; ++k)
  {
    const std::vector<ConstructedPoint> ends =
      EndsWithin(surface, { { ids[k], ids[(k + 1) % 3] } }, other);
    if (!ends.empty())
    {
      edges.push_back(Span(surface, ends));
    }
  }
  return edges;
}
} // namespace insideout
