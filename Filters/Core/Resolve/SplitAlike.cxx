// SPDX-License-Identifier: GPL-3.0-or-later
#include "Resolve/SplitAlike.h"

#include "Common/Vectors.h"

#include <algorithm>
#include <map>

namespace insideout
{
namespace
{
/** Limit of splits, because rounded positions may contradict each other. */
constexpr std::size_t SplitsPerEdge = 20;

/** The directed boundary edges of a facet's pieces, by their starts. */
using Boundary = std::map<Id, Id>;

/** The boundary of the pieces of each facet of a subdivision, in the subdivision's points. */
std::map<Id, Boundary> BoundariesOf(const PlanarSubdivision& subdivision)
{
  std::map<Id, std::map<std::array<Id, 2>, bool>> edges;
  for (const Piece& piece : subdivision.Pieces)
  {
    for (const PieceSource& source : piece.Sources)
    {
      auto& ofFacet = edges[source.Facet];
      for (int k = 0; k < 3; ++k)
      {
        std::array<Id, 2> edge = { piece.Corners[k], piece.Corners[(k + 1) % 3] };
        if (source.Reversed)
        {
          std::swap(edge[0], edge[1]);
        }
        const auto back = ofFacet.find({ edge[1], edge[0] });
        if (back != ofFacet.end())
        {
          ofFacet.erase(back);
        }
        else
        {
          ofFacet[edge] = true;
        }
      }
    }
  }
  std::map<Id, Boundary> boundaries;
  for (const auto& ofFacet : edges)
  {
    for (const auto& edge : ofFacet.second)
    {
      boundaries[ofFacet.first].insert({ edge.first[0], edge.first[1] });
    }
  }
  return boundaries;
}

/** The position of a point along an edge, in doubles. */
double Along(const std::vector<Point>& points, const Edge& edge, Id p)
{
  const Point& from = points[edge[0]];
  return Dot(Difference(points[p], from), Difference(points[edge[1]], from));
}

/** Sort the points on an edge from its first end to its last, and remove the ends. */
std::vector<Id> InOrder(const std::vector<Point>& points, const Edge& edge, std::vector<Id> on)
{
  const auto place = [&](Id p) { return std::make_pair(Along(points, edge, p), p); };
  const auto isEnd = [&](Id p) { return p == edge[0] || p == edge[1]; };
  on.erase(std::remove_if(on.begin(), on.end(), isEnd), on.end());
  std::sort(on.begin(), on.end(), [&](Id p, Id q) { return place(p) < place(q); });
  on.erase(std::unique(on.begin(), on.end()), on.end());
  return on;
}

/** The points between two others in a list that includes the ends of its edge. */
std::vector<Id> Between(const std::vector<Id>& all, Id p, Id q)
{
  const auto first = std::find(all.begin(), all.end(), p);
  const auto last = std::find(all.begin(), all.end(), q);
  return { std::min(first, last) + 1, std::max(first, last) };
}

/**
 * The points that split each edge: edges of facets, and edges between points of a chain that other
 * chains split.
 */
std::map<Edge, std::vector<Id>> PointsWithin(
  const std::vector<Point>& points, const std::vector<EdgeChain>& chains)
{
  std::map<Edge, std::vector<Id>> within;
  for (const EdgeChain& chain : chains)
  {
    std::vector<Id>& on = within[chain.Along];
    on.insert(on.end(), chain.Points.begin(), chain.Points.end());
  }
  std::map<Edge, std::vector<Id>> ofParts;
  for (auto& [edge, on] : within)
  {
    on = InOrder(points, edge, std::move(on));
  }
  for (const EdgeChain& chain : chains)
  {
    std::vector<Id> all = within[chain.Along];
    all.insert(all.begin(), chain.Along[0]);
    all.push_back(chain.Along[1]);
    for (std::size_t i = 1; i < chain.Points.size(); ++i)
    {
      const std::vector<Id> more = Between(all, chain.Points[i - 1], chain.Points[i]);
      std::vector<Id>& on = ofParts[EdgeBetween(chain.Points[i - 1], chain.Points[i])];
      on.insert(on.end(), more.begin(), more.end());
    }
  }
  for (auto& [edge, on] : ofParts)
  {
    std::vector<Id>& all = within[edge];
    all.insert(all.end(), on.begin(), on.end());
    all = InOrder(points, edge, std::move(all));
  }
  return within;
}
} // namespace

std::vector<EdgeChain> ChainsOf(const PlanarSubdivision& subdivision, const std::vector<Id>& ids)
{
  const std::map<Id, Boundary> boundaries = BoundariesOf(subdivision);
  std::vector<EdgeChain> chains;
  for (const SubdividedFacet& facet : subdivision.Facets)
  {
    const Boundary& boundary = boundaries.at(facet.Facet);
    const Triangle& corners = facet.Corners;
    for (int k = 0; k < 3; ++k)
    {
      // The subdivision has only one of two coincident corners: the chain begins at the other.
      const int next = (k + 1) % 3;
      std::vector<Id> chain = { corners[k], ids[facet.Places[k]] };
      for (Id p = facet.Places[k]; p != facet.Places[next];)
      {
        p = boundary.at(p);
        chain.push_back(ids[p]);
      }
      chain.push_back(corners[next]);
      chain.erase(std::unique(chain.begin(), chain.end()), chain.end());
      if (corners[k] > corners[next])
      {
        std::reverse(chain.begin(), chain.end());
      }
      chains.push_back({ EdgeBetween(corners[k], corners[next]), std::move(chain) });
    }
  }
  return chains;
}

Replacement SplitAlike(const std::vector<Point>& points, const std::vector<Triangle>& facets,
  const std::vector<EdgeChain>& chains)
{
  const std::map<Edge, std::vector<Id>> within = PointsWithin(points, chains);
  SplittableFacets splittable(points.size(), facets);
  std::vector<Edge> front;
  for (const auto& edge : within)
  {
    front.push_back(edge.first);
  }
  for (std::size_t left = SplitsPerEdge * front.size(); !front.empty() && left > 0; --left)
  {
    const Edge edge = front.back();
    front.pop_back();
    const std::vector<Id>& inside = within.at(edge);
    Id from = edge[0];
    for (const Id p : inside)
    {
      splittable.Split(EdgeBetween(from, edge[1]), p);
      from = p;
    }
    // Edges of several chains may overlap: the new edges may need splitting, too.
    from = edge[0];
    for (std::size_t i = 0; i <= inside.size() && !inside.empty(); ++i)
    {
      const Id to = i < inside.size() ? inside[i] : edge[1];
      if (within.count(EdgeBetween(from, to)) != 0)
      {
        front.push_back(EdgeBetween(from, to));
      }
      from = to;
    }
  }
  return splittable.Result();
}
} // namespace insideout
