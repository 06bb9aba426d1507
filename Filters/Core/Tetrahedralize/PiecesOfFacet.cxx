// SPDX-License-Identifier: GPL-3.0-or-later
#include "Tetrahedralize/PiecesOfFacet.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace insideout
{
namespace
{
/** The edge of a piece from its corner to the next. */
struct Side
{
  std::size_t Piece;
  bool Descending; ///< runs from the higher id to the lower
};

using Edge = std::pair<Id, Id>; ///< lower id first
using Sides = std::map<Edge, std::vector<Side>>;

Sides CollectSides(const std::vector<Triangle>& pieces)
{
  Sides sides;
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Id from = pieces[p][k];
      const Id to = pieces[p][(k + 1) % 3];
      sides[std::minmax(from, to)].push_back({ p, from > to });
    }
  }
  return sides;
}

/**
 * Propagate piece 0's orientation over shared edges. @return whether it reaches all pieces and
 * agrees
 */
bool Orient(const std::vector<Triangle>& pieces, const Sides& sides, std::vector<int>& turn)
{
  turn.assign(pieces.size(), 0);
  turn[0] = 1;
  std::vector<std::size_t> reached = { 0 };
  for (std::size_t next = 0; next < reached.size(); ++next)
  {
    const std::size_t piece = reached[next];
    for (int k = 0; k < 3; ++k)
    {
      const std::vector<Side>& shared =
        sides.at(std::minmax(pieces[piece][k], pieces[piece][(k + 1) % 3]));
      if (shared.size() > 2)
      {
        return false;
      }
      if (shared.size() < 2)
      {
        continue;
      }
      const std::size_t other = shared[0].Piece == piece ? shared[1].Piece : shared[0].Piece;
      const int expected =
        shared[0].Descending == shared[1].Descending ? -turn[piece] : turn[piece];
      if (turn[other] == 0)
      {
        turn[other] = expected;
        reached.push_back(other);
      }
      else if (turn[other] != expected)
      {
        return false;
      }
    }
  }
  return reached.size() == pieces.size();
}

/** The boundary edges of one piece as a loop from `start`; empty if they do not form one loop. */
std::vector<Id> BoundaryLoop(const Sides& sides, const std::vector<int>& turn, Id start)
{
  std::map<Id, Id> next;
  for (const auto& entry : sides)
  {
    if (entry.second.size() == 1)
    {
      const Side& side = entry.second[0];
      const bool descends = side.Descending == (turn[side.Piece] > 0);
      const Id from = descends ? entry.first.second : entry.first.first;
      const Id to = descends ? entry.first.first : entry.first.second;
      if (!next.insert({ from, to }).second)
      {
        return {};
      }
    }
  }
  std::vector<Id> loop;
  Id at = start;
  do
  {
    const auto step = next.find(at);
    if (step == next.end() || loop.size() == next.size())
    {
      return {};
    }
    loop.push_back(at);
    at = step->second;
  } while (at != start);
  return loop.size() == next.size() ? loop : std::vector<Id>();
}

bool CutAtCorners(const std::vector<Id>& loop, const Triangle& facet, PiecesOfFacet& result)
{
  const auto second = std::find(loop.begin(), loop.end(), facet[1]);
  const auto third = std::find(loop.begin(), loop.end(), facet[2]);
  if (second == loop.end() || third == loop.end() || third < second)
  {
    return false;
  }
  result.EdgePoints[0].assign(loop.begin() + 1, second);
  result.EdgePoints[1].assign(second + 1, third);
  result.EdgePoints[2].assign(third + 1, loop.end());
  return true;
}
} // namespace

bool MatchPiecesOfFacet(
  const Triangle& facet, const std::vector<Triangle>& pieces, PiecesOfFacet& result)
{
  if (pieces.empty())
  {
    return false;
  }
  const Sides sides = CollectSides(pieces);
  std::vector<int> turn;
  if (!Orient(pieces, sides, turn))
  {
    return false;
  }
  std::vector<Id> loop = BoundaryLoop(sides, turn, facet[0]);
  if (loop.empty())
  {
    return false;
  }
  bool flip = false;
  if (!CutAtCorners(loop, facet, result))
  {
    flip = true;
    std::reverse(loop.begin() + 1, loop.end());
    if (!CutAtCorners(loop, facet, result))
    {
      return false;
    }
  }
  result.Pieces = pieces;
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    if ((turn[p] > 0) == flip)
    {
      std::swap(result.Pieces[p][1], result.Pieces[p][2]);
    }
  }
  return true;
}

PointOrigin ComposeOrigin(
  const std::array<PointOrigin, 3>& corners, const std::array<double, 3>& weights)
{
  std::array<Id, 3> points;
  std::array<double, 3> sums = { 0, 0, 0 };
  int count = 0;
  for (int corner = 0; corner < 3; ++corner)
  {
    for (int k = 0; k < 3; ++k)
    {
      const double weight = weights[corner] * corners[corner].Weights[k];
      if (weight == 0)
      {
        continue;
      }
      const Id point = corners[corner].Points[k];
      const int slot =
        static_cast<int>(std::find(points.begin(), points.begin() + count, point) - points.begin());
      if (slot == 3)
      {
        const PointOrigin& nearest =
          corners[std::max_element(weights.begin(), weights.end()) - weights.begin()];
        return nearest.IsInput() ? PointOrigin::Like(nearest.Points[0]) : nearest;
      }
      if (slot == count)
      {
        points[count++] = point;
      }
      sums[slot] += weight;
    }
  }
  if (count == 1)
  {
    return PointOrigin::Like(points[0]);
  }
  // Unused slots repeat the first point with weight 0.
  std::fill(points.begin() + count, points.end(), points[0]);
  const double total = std::accumulate(sums.begin(), sums.end(), 0.0);
  return { points, { { sums[0] / total, sums[1] / total, sums[2] / total } } };
}
} // namespace insideout
