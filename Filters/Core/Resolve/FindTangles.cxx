// SPDX-License-Identifier: GPL-3.0-or-later
#include "Resolve/FindTangles.h"

#include "Common/DisjointSets.h"
#include "Common/NearestPoint.h"
#include "Common/SortUniquely.h"
#include "Common/TrianglePredicates.h"
#include "Common/Vectors.h"
#include "Resolve/FacetMeeting.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace insideout
{
namespace
{
/** Limit of points on three facets: cutting them makes 400,000 pieces, in a quarter of a minute. */
constexpr std::size_t MostCrossings = std::size_t{ 1 } << 16;

/** Facets with fewer pairs do not count: at most 1,953 cuts cross on each. */
constexpr std::size_t ManyPairs = 64;

/** Limit of the distance of a facet or edge from the center, as a fraction of its length. */
constexpr double MostDistance = 1.0 / 64;

/**
 * Limit of the distance of a facet's plane from the center, as a fraction of the facet's height.
 * Sides of needles that pass through one another are further from where the needles' axes meet.
 */
constexpr double MostHeight = 1.0 / 32;

using Pairs = std::vector<std::array<Id, 2>>;

/** The pairs among facets with many pairs: connected ones, by their lowest facet. */
std::map<Id, Pairs> ClustersOf(std::size_t numberOfFacets, const Pairs& pairs)
{
  std::vector<std::size_t> counts(numberOfFacets, 0);
  for (const auto& [f, g] : pairs)
  {
    ++counts[f];
    ++counts[g];
  }
  Pairs among;
  std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(among),
    [&](const auto& pair) { return std::min(counts[pair[0]], counts[pair[1]]) >= ManyPairs; });
  DisjointSets sets(numberOfFacets);
  for (const auto& [f, g] : among)
  {
    sets.Join(f, g);
  }
  std::map<Id, Pairs> clusters;
  for (const auto& pair : among)
  {
    clusters[sets.Find(pair[0])].push_back(pair);
  }
  return clusters;
}

/** The segment along which a facet meets another, in doubles. */
struct NearCut
{
  Point First;
  Point Last;
};

/** A constructed point in doubles, not a number if its bounds are infinite. */
Point Near(const ConstructedPoint& name, const FacetList& surface)
{
  const LazyPoint point(name, surface, { 0, 0, 0 });
  Point near;
  for (int k = 0; k < 3; ++k)
  {
    const std::array<double, 2> range = point.Range(k);
    near[k] = range[0] / 2 + range[1] / 2;
  }
  return near;
}

/** Add the points where segments in one plane cross, in doubles. */
void AddCrossings(const std::vector<NearCut>& cuts, int axis, std::vector<Point>& crossings)
{
  const int x = (axis + 1) % 3;
  const int y = (axis + 2) % 3;
  const auto area = [&](const Point& p, const Point& q, const Point& r)
  { return (q[x] - p[x]) * (r[y] - p[y]) - (q[y] - p[y]) * (r[x] - p[x]); };
  for (std::size_t i = 0; i < cuts.size(); ++i)
  {
    const auto& [p, q] = cuts[i];
    for (std::size_t j = i + 1; j < cuts.size(); ++j)
    {
      const auto& [r, s] = cuts[j];
      const double ofR = area(p, q, r);
      const double ofS = area(p, q, s);
      if (ofR * ofS < 0 && area(r, s, p) * area(r, s, q) < 0)
      {
        Point crossing;
        for (int k = 0; k < 3; ++k)
        {
          crossing[k] = r[k] + ofR / (ofR - ofS) * (s[k] - r[k]);
        }
        if (IsFinite(crossing)) // areas may have overflowed
        {
          crossings.push_back(crossing);
        }
      }
    }
  }
}

/** The points where three facets meet, each on its lowest facet. @param[in] pairs sorted */
std::vector<Point> CrossingsOf(
  const FacetList& surface, const Pairs& pairs, Monitor& monitor, const ProgressRange& progress)
{
  std::vector<Point> crossings;
  for (auto pair = pairs.begin(); pair != pairs.end();)
  {
    monitor.Check(progress.Stage, progress.Begin);
    const Id facet = (*pair)[0];
    std::vector<NearCut> cuts;
    for (; pair != pairs.end() && (*pair)[0] == facet; ++pair)
    {
      const Meeting meeting = Meet(surface, facet, (*pair)[1]);
      if (!meeting.Overlap)
      {
        cuts.push_back({ Near(meeting.First, surface), Near(meeting.Last, surface) });
      }
    }
    AddCrossings(cuts, ProjectionAxis(CornersOf(surface, facet)), crossings);
  }
  return crossings;
}

/** The median of points, by coordinate. */
Point MedianOf(std::vector<Point> points)
{
  Point median;
  const auto middle = points.begin() + static_cast<std::ptrdiff_t>(points.size() / 2);
  for (int k = 0; k < 3; ++k)
  {
    std::nth_element(points.begin(), middle, points.end(),
      [k](const Point& p, const Point& q) { return p[k] < q[k]; });
    median[k] = (*middle)[k];
  }
  return median;
}

/** A center with the facets and edges near it. */
class Gatherer
{
public:
  Gatherer(const FacetList& surface, const Point& center)
    : Surface(surface)
    , Result{ center, {}, {}, 0, 0 }
  {
  }

  bool IsNear(Id facet) const;

  Tangle Gather(const Pairs& pairs);

private:
  std::array<Point, 3> PlacesOf(Id facet) const
  {
    return insideout::CornersOf(this->Surface.Points, this->Surface.Facets[facet]);
  }
  double DistanceTo(const std::array<Point, 3>& triangle) const
  {
    return Distance(NearestPointOf(triangle, this->Result.Center), this->Result.Center);
  }
  void AddEdges(Id facet);

  const FacetList& Surface;
  Tangle Result;
};

bool Gatherer::IsNear(Id facet) const
{
  const auto& [a, b, c] = this->PlacesOf(facet);
  const Point normal = NormalOf(a, b, c); // of length: height times longest edge
  const double longest = std::max({ Distance(a, b), Distance(b, c), Distance(c, a) });
  const double volume = std::abs(Dot(normal, Difference(this->Result.Center, a)));
  return volume * longest <= MostHeight * Dot(normal, normal) &&
    this->DistanceTo({ a, b, c }) <= MostDistance * longest;
}

void Gatherer::AddEdges(Id facet)
{
  const std::array<Point, 3> places = this->PlacesOf(facet);
  for (int k = 0; k < 3; ++k)
  {
    const int next = (k + 1) % 3;
    const double distance = this->DistanceTo({ places[k], places[next], places[next] });
    if (distance <= MostDistance * Distance(places[k], places[next]))
    {
      const Triangle& ids = this->Surface.Facets[facet];
      this->Result.Edges.push_back(EdgeBetween(ids[k], ids[next]));
      this->Result.Distance = std::max(this->Result.Distance, distance);
    }
  }
}

Tangle Gatherer::Gather(const Pairs& pairs)
{
  for (const auto& pair : pairs)
  {
    this->Result.Facets.insert(this->Result.Facets.end(), pair.begin(), pair.end());
  }
  SortUniquely(this->Result.Facets);
  for (const Id f : this->Result.Facets)
  {
    this->Result.Distance = std::max(this->Result.Distance, this->DistanceTo(this->PlacesOf(f)));
    this->AddEdges(f);
  }
  SortUniquely(this->Result.Edges);
  return std::move(this->Result);
}
} // namespace

std::vector<Tangle> FindTangles(const FacetList& surface,
  const std::vector<std::array<Id, 2>>& pairs, Monitor& monitor, const ProgressRange& progress)
{
  std::vector<Tangle> tangles;
  for (auto& cluster : ClustersOf(surface.Facets.size(), pairs))
  {
    Pairs& among = cluster.second;
    const std::vector<Point> crossings = CrossingsOf(surface, among, monitor, progress);
    if (crossings.size() > MostCrossings)
    {
      Gatherer gatherer(surface, MedianOf(crossings));
      const auto isFar = [&](const std::array<Id, 2>& pair)
      { return !gatherer.IsNear(pair[0]) || !gatherer.IsNear(pair[1]); };
      among.erase(std::remove_if(among.begin(), among.end(), isFar), among.end());
      const std::size_t count = CrossingsOf(surface, among, monitor, progress).size();
      if (count > MostCrossings)
      {
        tangles.push_back(gatherer.Gather(among));
        tangles.back().Crossings = count;
      }
    }
  }
  return tangles;
}
} // namespace insideout
