// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/ClosePieces.h"

#include "Common/ScaledPoints.h"
#include "Common/SortUniquely.h"
#include "WindingNumber/HoleCaps.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace insideout
{
namespace
{
// Winding numbers of pieces are right to 1e-14 or so, and sums of many to no less than this.
constexpr double RoundingOfSums = 1e-12;

/** Add a triangle to a surface; one that counts more often than a facet can is several facets. */
void Add(const Triangle& corners, int count, FacetComplex& surface)
{
  using FacetCount = std::numeric_limits<std::int16_t>;
  while (count != 0)
  {
    const int part = std::clamp<int>(count, FacetCount::min(), FacetCount::max());
    surface.Facets.push_back(corners);
    surface.Multiplicity.push_back(static_cast<std::int16_t>(part));
    count -= part;
  }
}

/** Sort edges, which run from lower to higher points, and add the counts of equal ones up. */
std::vector<CountedEdge> AddUp(std::vector<CountedEdge> edges)
{
  const auto ends = [](const CountedEdge& edge) { return std::pair(edge.From, edge.To); };
  std::sort(edges.begin(), edges.end(),
    [&](const CountedEdge& a, const CountedEdge& b) { return ends(a) < ends(b); });
  std::vector<CountedEdge> sums;
  for (auto edge = edges.begin(); edge != edges.end();)
  {
    CountedEdge sum = { edge->From, edge->To, 0 };
    for (; edge != edges.end() && ends(*edge) == ends(sum); ++edge)
    {
      sum.Count += edge->Count;
    }
    if (sum.Count != 0)
    {
      sums.push_back(sum);
    }
  }
  return sums;
}

std::vector<CountedTriangle> CapsOf(
  const std::vector<Point>& points, const std::vector<CountedEdge>& boundary)
{
  std::vector<CountedTriangle> all;
  for (const std::vector<CountedTriangle>& cap :
    CapHolesInOrder(ScaledPoints(points, -LargestExponent(points)), boundary).InIds())
  {
    all.insert(all.end(), cap.begin(), cap.end());
  }
  return MergeTriangles(all);
}

CountedPiece PieceOf(const std::vector<Point>& points, const std::vector<CountedTriangle>& chain)
{
  CountedPiece piece;
  piece.Surface.Points = points;
  for (const CountedTriangle& triangle : chain)
  {
    Add(triangle.Corners, triangle.Count, piece.Surface);
  }
  return piece;
}
} // namespace

Id ClosePieces::IdOf(const Point& point)
{
  const auto [found, isNew] = this->Ids.emplace(point, static_cast<Id>(this->Points.size()));
  if (isNew)
  {
    this->Points.push_back(point);
  }
  return found->second;
}

void ClosePieces::Close(FacetComplex& piece)
{
  this->LargestCoordinate =
    std::max(this->LargestCoordinate, insideout::LargestCoordinate(piece.Points));
  std::vector<CountedEdge> boundary =
    CountedBoundary(CountedFacets(piece), static_cast<Id>(piece.Points.size()));
  std::vector<Id> used;
  for (const CountedEdge& edge : boundary)
  {
    used.insert(used.end(), { edge.From, edge.To });
  }
  SortUniquely(used);
  std::vector<Point> points;
  std::vector<Id> ids; // here
  for (const Id p : used)
  {
    points.push_back(piece.Points[p]);
    ids.push_back(this->IdOf(points.back()));
  }
  for (CountedEdge& edge : boundary)
  {
    edge = { IndexIn(used, edge.From), IndexIn(used, edge.To), edge.Count };
    const Id from = ids[edge.From];
    const Id to = ids[edge.To];
    this->OpenEdges.push_back(
      from < to ? CountedEdge{ from, to, edge.Count } : CountedEdge{ to, from, -edge.Count });
  }
  for (const CountedTriangle& cap : CapsOf(points, boundary))
  {
    const auto [a, b, c] = cap.Corners;
    this->Caps.push_back({ { ids[a], ids[b], ids[c] }, cap.Count });
    Add({ used[a], used[b], used[c] }, -cap.Count, piece);
  }
}

std::vector<CountedPiece> ClosePieces::Rest() const
{
  std::vector<CountedEdge> boundary = AddUp(this->OpenEdges);
  std::vector<Point> points = this->Points;
  points.push_back({ this->LargestCoordinate, 0, 0 }); // so that all is scaled as in the surface
  const std::vector<CountedTriangle> caps = CapsOf(points, boundary);
  std::vector<CountedPiece> rest = {
    PieceOf(points, MergeTriangles(CloseChain(this->Caps, { caps }))), PieceOf(points, caps)
  };
  rest.back().Boundary = std::move(boundary);
  rest.erase(std::remove_if(rest.begin(), rest.end(),
               [](const CountedPiece& piece) { return piece.Surface.Facets.empty(); }),
    rest.end());
  return rest;
}

double SumOfClosed(double sum)
{
  const double half = std::round(2 * sum) / 2;
  return std::abs(sum - half) < RoundingOfSums ? half : sum;
}
} // namespace insideout
