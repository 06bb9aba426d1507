// SPDX-License-Identifier: GPL-3.0-or-later
#include "Resolve/CollapseSlivers.h"

#include "Common/PointPredicates.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <queue>
#include <set>
#include <tuple>

namespace insideout
{
namespace
{
/** Limit of work: slivers made by splits are examined, too, up to this number per candidate. */
constexpr std::size_t LooksPerCandidate = 100;

class Collapser
{
public:
  Collapser(const std::vector<Point>& points, const std::vector<Triangle>& facets, double radius)
    : Points(points)
    , Facets(points.size(), facets)
    , Radius(radius)
  {
  }

  Replacement Collapse(const std::vector<Id>& candidates);

private:
  bool IsCollinear(const Triangle& corners) const;
  int ApexOf(const Triangle& corners) const;
  bool IsSliver(const Triangle& corners, int apex) const;
  bool MaySplit(const Edge& edge, Id apex);
  void Enqueue(Id f);

  const std::vector<Point>& Points;
  SplittableFacets Facets;
  const double Radius;
  std::priority_queue<std::pair<double, Id>> Candidates; ///< by their longest edge
  std::set<std::array<Id, 3>> Done;                      ///< edges with the points that split them
};

void Collapser::Enqueue(Id f)
{
  double longest = 0;
  const Triangle& corners = this->Facets.CornersOf(f);
  for (int k = 0; k < 3; ++k)
  {
    longest =
      std::max(longest, Distance(this->Points[corners[k]], this->Points[corners[(k + 1) % 3]]));
  }
  this->Candidates.push({ longest, f });
}

/**
 * Split long edges first: parts have only shorter edges, so no sliver recurs. Remaining degenerate
 * facets are dropped.
 */
Replacement Collapser::Collapse(const std::vector<Id>& candidates)
{
  for (const Id f : candidates)
  {
    this->Enqueue(f);
  }
  for (std::size_t left = LooksPerCandidate * candidates.size();
       !this->Candidates.empty() && left > 0; --left)
  {
    const Id f = this->Candidates.top().second;
    this->Candidates.pop();
    const Triangle corners = this->Facets.CornersOf(f);
    const int apex = this->ApexOf(corners);
    const Edge edge = EdgeBetween(corners[(apex + 1) % 3], corners[(apex + 2) % 3]);
    if (this->Facets.IsThere(f) && this->IsSliver(corners, apex) &&
      (this->IsCollinear(corners) || this->MaySplit(edge, corners[apex])))
    {
      for (Id part = this->Facets.Split(edge, corners[apex]); part < this->Facets.Count(); ++part)
      {
        this->Enqueue(part);
      }
    }
  }
  for (; !this->Candidates.empty(); this->Candidates.pop())
  {
    const Id f = this->Candidates.top().second;
    if (this->IsCollinear(this->Facets.CornersOf(f)))
    {
      this->Facets.Remove(f);
    }
  }
  return this->Facets.Result();
}

bool Collapser::IsCollinear(const Triangle& corners) const
{
  return IsDegenerate(this->Points, corners);
}

/**
 * The corner opposite the longest edge. Among equally long edges it is the same one in every facet;
 * otherwise facets would split each other's edges in turn. If the corners are collinear, it is
 * exactly the middle one.
 */
int Collapser::ApexOf(const Triangle& corners) const
{
  const bool isCollinear = this->IsCollinear(corners);
  const auto opposite = [&](int k)
  {
    const Edge edge = EdgeBetween(corners[(k + 1) % 3], corners[(k + 2) % 3]);
    const Point& p = this->Points[edge[0]];
    const Point& q = this->Points[edge[1]];
    const Point& r = this->Points[corners[k]];
    const bool between = isCollinear && std::min(p, q) < r && r < std::max(p, q);
    return std::make_tuple(between, Distance(p, q), edge);
  };
  int apex = 0;
  for (int k = 1; k < 3; ++k)
  {
    apex = opposite(k) > opposite(apex) ? k : apex;
  }
  return apex;
}

/** Whether the apex is near the longest edge, which is opposite to it. */
bool Collapser::IsSliver(const Triangle& corners, int apex) const
{
  const Point& p = this->Points[corners[(apex + 1) % 3]];
  const Point& q = this->Points[corners[(apex + 2) % 3]];
  return Length(NormalOf(p, q, this->Points[corners[apex]])) <= this->Radius * Distance(p, q);
}

/**
 * Whether to split an edge at a corner that is not exactly on it: not twice, or two slivers would
 * replace each other forever; and not if a part would be degenerate.
 */
bool Collapser::MaySplit(const Edge& edge, Id apex)
{
  const std::vector<ReplacedFacet> parts = this->Facets.PartsOfSplit(edge, apex);
  return std::none_of(parts.begin(), parts.end(),
           [&](const ReplacedFacet& part) { return this->IsCollinear(part.Corners); }) &&
    this->Done.insert({ edge[0], edge[1], apex }).second;
}
} // namespace

Replacement CollapseSlivers(const std::vector<Point>& points, const std::vector<Triangle>& facets,
  const std::vector<Id>& candidates, double radius)
{
  return Collapser(points, facets, radius).Collapse(candidates);
}
} // namespace insideout
