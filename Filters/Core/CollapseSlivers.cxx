// SPDX-License-Identifier: GPL-3.0-or-later
#include "CollapseSlivers.h"

#include "TrianglePredicates.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>
#include <set>
#include <tuple>

namespace insideout
{
namespace
{
/** Slivers of slivers are looked at too, up to this many for each candidate. */
constexpr std::size_t LooksPerCandidate = 100;

using Edge = std::array<Id, 2>;

Edge EdgeBetween(Id p, Id q)
{
  return { std::min(p, q), std::max(p, q) };
}

bool HasCorner(const Triangle& corners, Id point)
{
  return std::find(corners.begin(), corners.end(), point) != corners.end();
}

double Distance(const Point& p, const Point& q)
{
  return std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
}

double DoubleArea(const Point& p, const Point& q, const Point& r)
{
  const Point a = { q[0] - p[0], q[1] - p[1], q[2] - p[2] };
  const Point b = { r[0] - p[0], r[1] - p[1], r[2] - p[2] };
  return std::hypot(
    a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
}

/** The facets at every point: those of point p from First[p] to First[p + 1]. */
struct FacetsAtPoints
{
  std::vector<Id> First;
  std::vector<Id> Facets;

  FacetsAtPoints(std::size_t numberOfPoints, const std::vector<Triangle>& facets)
    : First(numberOfPoints + 1, 0)
    , Facets(3 * facets.size())
  {
    for (const Triangle& t : facets)
    {
      for (const Id p : t)
      {
        ++this->First[p];
      }
    }
    Id sum = 0;
    for (Id& first : this->First)
    {
      sum += first;
      first = sum;
    }
    for (Id f = static_cast<Id>(facets.size()) - 1; f >= 0; --f)
    {
      for (const Id p : facets[f])
      {
        this->Facets[--this->First[p]] = f;
      }
    }
  }
};

class Collapser
{
public:
  Collapser(const std::vector<Point>& points, const std::vector<Triangle>& facets, double radius)
    : Points(points)
    , Given(facets)
    , Radius(radius)
    , AtPoints(points.size(), facets)
    , IsAlive(facets.size(), 1)
  {
  }

  void Collapse(const std::vector<Id>& candidates);
  CollapsedSlivers Result() const;

private:
  const Triangle& CornersOf(Id f) const;
  Id ParentOf(Id f) const;
  std::vector<Id> FacetsAlong(const Edge& edge) const;
  bool IsCollinear(const Triangle& corners) const;
  int ApexOf(const Triangle& corners) const;
  bool IsSliver(const Triangle& corners, int apex) const;
  void SplitAt(const Edge& edge, Id apex, bool isCollinear);
  void Append(const ReplacedFacet& part);
  void Enqueue(Id f);

  const std::vector<Point>& Points;
  const std::vector<Triangle>& Given;
  const double Radius;
  const FacetsAtPoints AtPoints;
  std::vector<ReplacedFacet> Added; ///< numbered after the given ones
  std::vector<char> IsAlive;
  std::map<Edge, std::vector<Id>> AddedAtEdge;
  std::priority_queue<std::pair<double, Id>> Candidates; ///< by their longest edge
  std::set<std::array<Id, 3>> Done;                      ///< edges and the points that split them
};

const Triangle& Collapser::CornersOf(Id f) const
{
  const Id given = static_cast<Id>(this->Given.size());
  return f < given ? this->Given[f] : this->Added[f - given].Corners;
}

Id Collapser::ParentOf(Id f) const
{
  const Id given = static_cast<Id>(this->Given.size());
  return f < given ? f : this->Added[f - given].Parent;
}

void Collapser::Append(const ReplacedFacet& part)
{
  const Id f = static_cast<Id>(this->IsAlive.size());
  this->Added.push_back(part);
  this->IsAlive.push_back(1);
  for (int k = 0; k < 3; ++k)
  {
    this->AddedAtEdge[EdgeBetween(part.Corners[k], part.Corners[(k + 1) % 3])].push_back(f);
  }
  this->Enqueue(f);
}

void Collapser::Enqueue(Id f)
{
  double longest = 0;
  const Triangle& corners = this->CornersOf(f);
  for (int k = 0; k < 3; ++k)
  {
    longest =
      std::max(longest, Distance(this->Points[corners[k]], this->Points[corners[(k + 1) % 3]]));
  }
  this->Candidates.push({ longest, f });
}

std::vector<Id> Collapser::FacetsAlong(const Edge& edge) const
{
  std::vector<Id> facets;
  for (Id i = this->AtPoints.First[edge[0]]; i < this->AtPoints.First[edge[0] + 1]; ++i)
  {
    const Id f = this->AtPoints.Facets[i];
    if (this->IsAlive[f] && HasCorner(this->Given[f], edge[1]))
    {
      facets.push_back(f);
    }
  }
  const auto added = this->AddedAtEdge.find(edge);
  if (added != this->AddedAtEdge.end())
  {
    std::copy_if(added->second.begin(), added->second.end(), std::back_inserter(facets),
      [&](Id f) { return this->IsAlive[f] != 0; });
  }
  return facets;
}

/**
 * Long edges come first: what a split leaves has no longer one, so that none comes back. Degenerate
 * facets that are left in the end are dropped.
 */
void Collapser::Collapse(const std::vector<Id>& candidates)
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
    const Triangle corners = this->CornersOf(f);
    const int apex = this->ApexOf(corners);
    if (this->IsAlive[f] && this->IsSliver(corners, apex))
    {
      this->SplitAt(EdgeBetween(corners[(apex + 1) % 3], corners[(apex + 2) % 3]), corners[apex],
        this->IsCollinear(corners));
    }
  }
  for (; !this->Candidates.empty(); this->Candidates.pop())
  {
    const Id f = this->Candidates.top().second;
    this->IsAlive[f] = this->IsAlive[f] && !this->IsCollinear(this->CornersOf(f));
  }
}

bool Collapser::IsCollinear(const Triangle& corners) const
{
  return IsDegenerate(this->Points[corners[0]], this->Points[corners[1]], this->Points[corners[2]]);
}

/**
 * The corner opposite the longest edge. Among edges as long as each other it is the same one in
 * every facet, lest the facets split each other's edges in turn. Of collinear corners it is exactly
 * the middle one.
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

/** Whether the apex is near the longest edge, which is the opposite one. */
bool Collapser::IsSliver(const Triangle& corners, int apex) const
{
  const Point& p = this->Points[corners[(apex + 1) % 3]];
  const Point& q = this->Points[corners[(apex + 2) % 3]];
  return DoubleArea(p, q, this->Points[corners[apex]]) <= this->Radius * Distance(p, q);
}

/**
 * Splits the facets along an edge, which leaves nothing of those with a corner there. Where that
 * corner is not exactly on the edge, not twice, lest two slivers turn into each other for ever, and
 * not if a part would be degenerate.
 */
void Collapser::SplitAt(const Edge& edge, Id apex, bool isCollinear)
{
  const std::vector<Id> facets = this->FacetsAlong(edge);
  std::vector<ReplacedFacet> parts;
  for (const Id f : facets)
  {
    for (const Id replaced : edge)
    {
      Triangle part = this->CornersOf(f);
      if (HasCorner(part, apex))
      {
        continue;
      }
      std::replace(part.begin(), part.end(), replaced, apex);
      if (!isCollinear && this->IsCollinear(part))
      {
        return;
      }
      parts.push_back({ part, this->ParentOf(f) });
    }
  }
  if (!isCollinear && !this->Done.insert({ edge[0], edge[1], apex }).second)
  {
    return;
  }
  for (const Id f : facets)
  {
    this->IsAlive[f] = 0;
  }
  for (const ReplacedFacet& part : parts)
  {
    this->Append(part);
  }
}

CollapsedSlivers Collapser::Result() const
{
  CollapsedSlivers result;
  const Id given = static_cast<Id>(this->Given.size());
  for (Id f = 0; f < given; ++f)
  {
    if (!this->IsAlive[f])
    {
      result.Removed.push_back(f);
    }
  }
  for (Id f = given; f < static_cast<Id>(this->IsAlive.size()); ++f)
  {
    if (this->IsAlive[f])
    {
      result.Added.push_back(this->Added[f - given]);
    }
  }
  return result;
}
} // namespace

CollapsedSlivers CollapseSlivers(const std::vector<Point>& points,
  const std::vector<Triangle>& facets, const std::vector<Id>& candidates, double radius)
{
  Collapser collapser(points, facets, radius);
  collapser.Collapse(candidates);
  return collapser.Result();
}
} // namespace insideout
