// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/TouchBodies.h"

#include "Boolean/TouchingFacets.h"
#include "Common/NearestPoint.h"
#include "Common/PointPredicates.h"
#include "Common/Stages.h"
#include "Common/Vectors.h"
#include "Resolve/FindIntersections.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

namespace insideout
{
namespace
{
/**
 * Factor on the rounding errors of two bodies, because coordinates computed in floats are off by
 * more than one rounding. Faces ten roundings apart stay at least 6.5 apart when rounded, so they
 * do not touch.
 */
constexpr double Slack = 1.5;

/** Limit of the pairs of bodies named in messages. */
constexpr std::size_t MostNamed = 10;

/** A facet of an earlier body onto which a point may move. */
struct Support
{
  Id Facet;
  double Tolerance;
};

/** Where a point goes. */
struct Move
{
  Id PointId;
  Point To;
  double Distance;
  Id Body; ///< the body of that facet
};

class BodyToucher
{
public:
  BodyToucher(std::vector<FacetComplex>& chains,
    const std::vector<std::optional<CoordinateGrid>>& grids, double tolerance,
    std::vector<std::vector<std::array<Id, 2>>>& crossings, Monitor& monitor)
    : Chains(chains)
    , Grids(grids)
    , Tolerance(tolerance)
    , Crossings(crossings)
    , Watch(monitor)
  {
  }

  Touches Touch();

private:
  double ToleranceOf(Id body, const Triangle& corners) const;
  std::array<Point, 3> CornersOf(Id facet) const;
  std::map<Id, std::vector<Support>> SupportsOf(Id body) const;
  std::optional<Move> MoveOf(const Point& p, const std::vector<Support>& supports) const;
  Point OntoEarlier(const Point& p, const std::vector<Support>& supports, Id body) const;
  void MovePoints(Id body);
  std::set<Id> HarmfulMoves(Id body, const std::vector<Point>& before);
  bool AreInOnePlane(const TouchingPair& pair) const;
  void Report();

  std::vector<FacetComplex>& Chains;
  const std::vector<std::optional<CoordinateGrid>>& Grids;
  const double Tolerance;
  std::vector<std::vector<std::array<Id, 2>>>& Crossings;
  Monitor& Watch;

  std::vector<Triangle> Facets; ///< of all chains, by corners of each chain
  std::vector<Id> BodyOf;       ///< of each of these
  std::vector<double> Tolerances;
  std::vector<TouchingPair> Pairs;
  std::map<std::array<Id, 2>, TouchingBodies> Contacts;
};

/** A facet's share in the tolerance of a pair; negative if it cannot touch anything. */
double BodyToucher::ToleranceOf(Id body, const Triangle& corners) const
{
  if (this->Tolerance > 0)
  {
    return this->Tolerance / 2;
  }
  if (!this->Grids[body])
  {
    return -1;
  }
  Point rounding = { 0, 0, 0 };
  for (const Id p : corners)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      rounding[axis] =
        std::max(rounding[axis], this->Grids[body]->RoundingAt(this->Chains[body].Points[p][axis]));
    }
  }
  return Slack * Length(rounding);
}

std::array<Point, 3> BodyToucher::CornersOf(Id facet) const
{
  return insideout::CornersOf(this->Chains[this->BodyOf[facet]].Points, this->Facets[facet]);
}

/** Per point of a body, the facets of earlier bodies that touch facets at the point. */
std::map<Id, std::vector<Support>> BodyToucher::SupportsOf(Id body) const
{
  std::map<Id, std::vector<Support>> supports;
  for (const TouchingPair& pair : this->Pairs)
  {
    if (this->BodyOf[pair.Second] == body)
    {
      for (const Id p : this->Facets[pair.Second])
      {
        supports[p].push_back(
          { pair.First, this->Tolerances[pair.First] + this->Tolerances[pair.Second] });
      }
    }
  }
  return supports;
}

/**
 * The position of a point on an edge of a body, moved onto the facet of the earliest body near it.
 */
Point BodyToucher::OntoEarlier(const Point& p, const std::vector<Support>& supports, Id body) const
{
  Point to = p;
  double nearest = 0;
  for (const Support& support : supports)
  {
    const Id earlier = this->BodyOf[support.Facet];
    const Point there = NearestPointOf(this->CornersOf(support.Facet), p);
    const double distance = Distance(there, p);
    if (distance <= support.Tolerance &&
      (earlier < body || (earlier == body && distance < nearest)))
    {
      body = earlier;
      to = there;
      nearest = distance;
    }
  }
  return to;
}

std::optional<Move> BodyToucher::MoveOf(const Point& p, const std::vector<Support>& supports) const
{
  std::optional<Move> nearest;
  const auto look = [&](const std::array<Point, 3>& place, const Support& support)
  {
    const Point to = NearestPointOf(place, p);
    const double distance = Distance(to, p);
    if (distance <= support.Tolerance && (!nearest || distance < nearest->Distance))
    {
      nearest = { None, to, distance, this->BodyOf[support.Facet] };
    }
  };
  for (int dimension = 0; dimension < 3 && !nearest; ++dimension)
  {
    for (const Support& support : supports)
    {
      const std::array<Point, 3> corners = this->CornersOf(support.Facet);
      for (int k = 0; k < (dimension == 2 ? 1 : 3); ++k)
      {
        const Point& a = corners[k];
        const Point& b = dimension == 0 ? a : corners[(k + 1) % 3];
        const Point& c = dimension < 2 ? b : corners[2];
        look({ a, b, c }, support);
      }
    }
    if (nearest && dimension > 0)
    {
      nearest->To = this->OntoEarlier(nearest->To, supports, nearest->Body);
      nearest->Distance = Distance(nearest->To, p);
    }
  }
  return nearest && nearest->To != p ? nearest : std::nullopt;
}

/** The points whose moves turned a facet over, or made facets cross. */
std::set<Id> BodyToucher::HarmfulMoves(Id body, const std::vector<Point>& before)
{
  const FacetComplex& chain = this->Chains[body];
  std::set<Id> harmful;
  const auto blame = [&](const Triangle& corners)
  {
    for (const Id p : corners)
    {
      if (chain.Points[p] != before[p])
      {
        harmful.insert(p);
      }
    }
  };
  for (const Triangle& corners : chain.Facets)
  {
    const std::array<Point, 3> now = insideout::CornersOf(chain.Points, corners);
    const std::array<Point, 3> then = insideout::CornersOf(before, corners);
    if (now != then &&
      (IsDegenerate(chain.Points, corners) ||
        Dot(NormalOf(now[0], now[1], now[2]), NormalOf(then[0], then[1], then[2])) <= 0))
    {
      blame(corners);
    }
  }
  if (harmful.empty())
  {
    const std::vector<std::array<Id, 2>> crossings =
      FindIntersections(chain.Points, chain.Facets, this->Watch);
    std::vector<std::array<Id, 2>> made;
    std::set_difference(crossings.begin(), crossings.end(), this->Crossings[body].begin(),
      this->Crossings[body].end(), std::back_inserter(made));
    for (const auto& pair : made)
    {
      blame(chain.Facets[pair[0]]);
      blame(chain.Facets[pair[1]]);
    }
    if (made.empty())
    {
      this->Crossings[body] = crossings;
    }
  }
  return harmful;
}

void BodyToucher::MovePoints(Id body)
{
  std::vector<Point>& points = this->Chains[body].Points;
  std::vector<Move> moves;
  for (const auto& [p, supports] : this->SupportsOf(body))
  {
    if (auto move = this->MoveOf(points[p], supports))
    {
      move->PointId = p;
      moves.push_back(*move);
    }
  }
  if (moves.empty())
  {
    return;
  }
  std::stable_sort(moves.begin(), moves.end(),
    [](const Move& a, const Move& b) { return a.Distance < b.Distance; });
  const std::vector<Point> before = points;
  std::set<Point> taken(points.begin(), points.end());
  for (const Move& move : moves)
  {
    if (taken.insert(move.To).second)
    {
      points[move.PointId] = move.To;
    }
  }
  for (std::set<Id> harmful = this->HarmfulMoves(body, before); !harmful.empty();
       harmful = this->HarmfulMoves(body, before))
  {
    for (const Id p : harmful)
    {
      points[p] = before[p];
    }
  }
  for (const Move& move : moves)
  {
    if (points[move.PointId] != before[move.PointId])
    {
      TouchingBodies& contact = this->Contacts[{ move.Body, body }];
      ++contact.MovedPoints;
      contact.Distance = std::max(contact.Distance, move.Distance);
    }
  }
}

bool BodyToucher::AreInOnePlane(const TouchingPair& pair) const
{
  const auto [a, b, c] = this->CornersOf(pair.First);
  for (const Point& p : this->CornersOf(pair.Second))
  {
    if (Orient3D(a, b, c, p) != 0)
    {
      return false;
    }
  }
  return true;
}

Touches BodyToucher::Touch()
{
  const auto onGrids = std::count_if(
    this->Grids.begin(), this->Grids.end(), [](const auto& grid) { return grid.has_value(); });
  if (this->Tolerance <= 0 && onGrids < 2)
  {
    return {};
  }
  std::vector<Point> points;
  std::vector<Triangle> facets;
  for (std::size_t b = 0; b < this->Chains.size(); ++b)
  {
    const FacetComplex& chain = this->Chains[b];
    const Id first = static_cast<Id>(points.size());
    points.insert(points.end(), chain.Points.begin(), chain.Points.end());
    for (const Triangle& corners : chain.Facets)
    {
      facets.push_back({ corners[0] + first, corners[1] + first, corners[2] + first });
      this->Facets.push_back(corners);
      this->BodyOf.push_back(static_cast<Id>(b));
      this->Tolerances.push_back(this->ToleranceOf(static_cast<Id>(b), corners));
    }
  }
  this->Pairs = FindTouchingFacets(points, facets, this->BodyOf, this->Tolerances, this->Watch);
  Touches touches;
  if (this->Pairs.empty())
  {
    return touches;
  }
  for (Id b = 1; b < static_cast<Id>(this->Chains.size()); ++b)
  {
    this->MovePoints(b);
  }
  for (const TouchingPair& pair : this->Pairs)
  {
    const std::array<Id, 2> bodies = { this->BodyOf[pair.First], this->BodyOf[pair.Second] };
    if (!this->AreInOnePlane(pair))
    {
      TouchingBodies& contact = this->Contacts[bodies];
      contact.Distance = std::max(contact.Distance, pair.Distance);
    }
  }
  // Faces that touch exactly may bend beside faces that do not: all of them move, or none.
  for (std::size_t i = 0; !this->Contacts.empty() && i < this->Pairs.size(); ++i)
  {
    const TouchingPair& pair = this->Pairs[i];
    touches.Facets.Pairs.push_back({ pair.First, pair.Second });
    touches.Facets.Radius =
      std::max(touches.Facets.Radius, this->Tolerances[pair.First] + this->Tolerances[pair.Second]);
  }
  for (const auto& [bodies, contact] : this->Contacts)
  {
    touches.Bodies.push_back({ bodies[0], bodies[1], contact.MovedPoints, contact.Distance });
  }
  return touches;
}
} // namespace

Touches TouchBodies(std::vector<FacetComplex>& chains,
  const std::vector<std::optional<CoordinateGrid>>& grids, double tolerance,
  std::vector<std::vector<std::array<Id, 2>>>& crossings, Monitor& monitor)
{
  return BodyToucher(chains, grids, tolerance, crossings, monitor).Touch();
}

double TouchToleranceOf(double roundings)
{
  const double enough = Slack * std::sqrt(3.0) * roundings;
  const double unit = std::pow(10, std::floor(std::log10(enough)));
  return std::ceil(enough / unit) * unit;
}

std::vector<std::string> WordsOf(
  const std::vector<TouchingBodies>& touching, const std::vector<std::string>& names)
{
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < std::min(touching.size(), MostNamed); ++i)
  {
    const TouchingBodies& pair = touching[i];
    std::ostringstream line;
    line.precision(2);
    line << "bodies " << names[pair.First] << " and " << names[pair.Second] << " touch within "
         << pair.Distance << ", closed: " << pair.MovedPoints
         << (pair.MovedPoints == 1 ? " point of " : " points of ") << names[pair.Second]
         << " moved";
    lines.push_back(line.str());
  }
  if (touching.size() > MostNamed)
  {
    lines.push_back(std::to_string(touching.size() - MostNamed) +
      " more pairs of bodies touch but for rounding, closed");
  }
  return lines;
}
} // namespace insideout
