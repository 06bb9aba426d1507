// SPDX-License-Identifier: GPL-3.0-or-later
#include "Tetrahedralize/PiecesOfFacet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

using namespace insideout;

namespace
{
const Triangle Facet = { { 0, 1, 2 } };

/** Split a triangle at random: each step puts a new point in a piece or on an edge. */
std::vector<Triangle> RandomPieces(std::mt19937& random, int steps)
{
  std::vector<Triangle> pieces = { Facet };
  Id next = 3;
  for (int step = 0; step < steps; ++step, ++next)
  {
    const Triangle t = pieces[random() % pieces.size()];
    if (random() % 2)
    {
      pieces.erase(std::find(pieces.begin(), pieces.end(), t));
      for (int k = 0; k < 3; ++k)
      {
        pieces.push_back({ { t[k], t[(k + 1) % 3], next } });
      }
      continue;
    }
    const Id a = t[0];
    const Id b = t[1];
    std::vector<Triangle> split;
    for (const Triangle& piece : pieces)
    {
      const auto hasA = std::find(piece.begin(), piece.end(), a);
      const auto hasB = std::find(piece.begin(), piece.end(), b);
      if (hasA == piece.end() || hasB == piece.end())
      {
        split.push_back(piece);
        continue;
      }
      Triangle half = piece;
      half[hasA - piece.begin()] = next;
      split.push_back(half);
      half = piece;
      half[hasB - piece.begin()] = next;
      split.push_back(half);
    }
    pieces = split;
  }
  return pieces;
}

/** Signed edges of the pieces and of the loop through the edge points, which must cancel. */
bool BoundaryIsTheFacets(const PiecesOfFacet& parts)
{
  std::map<std::pair<Id, Id>, int> sum;
  const auto add = [&](Id from, Id to, int sign)
  { sum[std::minmax(from, to)] += from < to ? sign : -sign; };
  for (const Triangle& piece : parts.Pieces)
  {
    for (int k = 0; k < 3; ++k)
    {
      add(piece[k], piece[(k + 1) % 3], 1);
    }
  }
  for (int k = 0; k < 3; ++k)
  {
    Id at = Facet[k];
    for (const Id p : parts.EdgePoints[k])
    {
      add(at, p, -1);
      at = p;
    }
    add(at, Facet[(k + 1) % 3], -1);
  }
  return std::all_of(sum.begin(), sum.end(), [](const auto& edge) { return edge.second == 0; });
}
/** Whether a piece has a side that no other piece has. */
bool HasSideOfItsOwn(const std::vector<Triangle>& pieces, std::size_t which)
{
  for (int k = 0; k < 3; ++k)
  {
    const Id skipped = pieces[which][k];
    const auto hasSide = [&](const Triangle& piece)
    {
      return std::all_of(pieces[which].begin(), pieces[which].end(),
        [&](Id p)
        { return p == skipped || std::find(piece.begin(), piece.end(), p) != piece.end(); });
    };
    if (std::count_if(pieces.begin(), pieces.end(), hasSide) == 1)
    {
      return true;
    }
  }
  return false;
}
} // namespace

TEST(PiecesOfFacet, AreTurnedSoThatTheirEdgesSumToTheFacets)
{
  std::mt19937 random(1);
  for (int run = 0; run < 500; ++run)
  {
    std::vector<Triangle> pieces = RandomPieces(random, run % 30);
    for (Triangle& piece : pieces)
    {
      std::shuffle(piece.begin(), piece.end(), random);
    }
    std::shuffle(pieces.begin(), pieces.end(), random);
    PiecesOfFacet parts;
    ASSERT_TRUE(MatchPiecesOfFacet(Facet, pieces, parts));
    ASSERT_EQ(parts.Pieces.size(), pieces.size());
    ASSERT_TRUE(BoundaryIsTheFacets(parts));
  }
}

TEST(PiecesOfFacet, AreNotTheFacetWhereOneIsMissingOrTooMany)
{
  std::mt19937 random(2);
  for (int run = 0; run < 200; ++run)
  {
    const std::vector<Triangle> pieces = RandomPieces(random, 1 + run % 30);
    PiecesOfFacet parts;
    std::vector<Triangle> fewer = pieces;
    const std::size_t missing = random() % fewer.size();
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(missing));
    // Ids alone cannot tell a dent in the facet's edge from an edge with one more point on it.
    EXPECT_TRUE(!MatchPiecesOfFacet(Facet, fewer, parts) ||
      (HasSideOfItsOwn(pieces, missing) && BoundaryIsTheFacets(parts)));
    std::vector<Triangle> more = pieces;
    more.push_back(more[random() % more.size()]);
    EXPECT_FALSE(MatchPiecesOfFacet(Facet, more, parts));
    more.back() = { { 100, 101, 102 } };
    EXPECT_FALSE(MatchPiecesOfFacet(Facet, more, parts));
  }
}

TEST(PiecesOfFacet, AreNotTheFacetWhereTheyDoNotCloseUp)
{
  PiecesOfFacet parts;
  EXPECT_FALSE(MatchPiecesOfFacet(Facet, {}, parts));
  EXPECT_FALSE(MatchPiecesOfFacet(Facet, { { { 0, 1, 3 } } }, parts));
  EXPECT_FALSE(MatchPiecesOfFacet(Facet, { { { 0, 1, 3 } }, { { 1, 2, 4 } } }, parts));
  // A Moebius strip has no orientation.
  EXPECT_FALSE(MatchPiecesOfFacet(Facet,
    { { { 0, 1, 2 } }, { { 1, 2, 3 } }, { { 2, 3, 4 } }, { { 3, 4, 0 } }, { { 4, 0, 1 } } },
    parts));
  // A ring around a hole has two loops.
  EXPECT_FALSE(MatchPiecesOfFacet(Facet,
    { { { 0, 1, 3 } }, { { 1, 4, 3 } }, { { 1, 2, 4 } }, { { 2, 5, 4 } }, { { 2, 0, 5 } },
      { { 0, 3, 5 } } },
    parts));
}

TEST(ComposeOrigin, OfInputPointsIsTheirWeights)
{
  const PointOrigin origin = ComposeOrigin(
    { PointOrigin::Input(7), PointOrigin::Input(8), PointOrigin::Input(9) }, { 0.25, 0.25, 0.5 });
  EXPECT_EQ(origin.Points, (Triangle{ { 7, 8, 9 } }));
  EXPECT_EQ(origin.Weights, (std::array<double, 3>{ { 0.25, 0.25, 0.5 } }));
}

TEST(ComposeOrigin, OnAnEdgeLeavesTheThirdCornerOut)
{
  const PointOrigin origin = ComposeOrigin(
    { PointOrigin::Input(7), PointOrigin::Input(8), PointOrigin::Input(9) }, { 0.75, 0, 0.25 });
  EXPECT_EQ(origin.Points, (Triangle{ { 7, 9, 7 } }));
  EXPECT_EQ(origin.Weights, (std::array<double, 3>{ { 0.75, 0.25, 0 } }));
}

TEST(ComposeOrigin, MultipliesWeightsWhereCornersInterpolateTheSamePoints)
{
  const PointOrigin first = { { { 7, 8, 9 } }, { { 0.5, 0.25, 0.25 } } };
  const PointOrigin second = { { { 9, 7, 7 } }, { { 0.5, 0.5, 0 } } };
  const PointOrigin origin =
    ComposeOrigin({ first, second, PointOrigin::Input(8) }, { 0.5, 0.25, 0.25 });
  EXPECT_EQ(origin.Points, (Triangle{ { 7, 8, 9 } }));
  EXPECT_EQ(origin.Weights, (std::array<double, 3>{ { 0.375, 0.375, 0.25 } }));
}

TEST(ComposeOrigin, IsNeverThatOfAnInputPoint)
{
  const PointOrigin seven = PointOrigin::Input(7);
  const PointOrigin edge = { { { 8, 9, 8 } }, { { 0.5, 0.5, 0 } } };
  const PointOrigin other = { { { 10, 9, 10 } }, { { 0.5, 0.5, 0 } } };
  for (const PointOrigin& origin :
    { ComposeOrigin({ seven, edge, PointOrigin::Input(8) }, { 1, 0, 0 }),
      ComposeOrigin({ seven, edge, other }, { 0.5, 0.25, 0.25 }) })
  {
    EXPECT_EQ(origin.Points, seven.Points);
    EXPECT_FALSE(origin.IsInput());
  }
}

TEST(ComposeOrigin, TakesTheNearestCornerWhereMoreThanThreePointsTakePart)
{
  const PointOrigin first = { { { 7, 8, 9 } }, { { 0.5, 0.25, 0.25 } } };
  const PointOrigin second = { { { 10, 7, 7 } }, { { 0.5, 0.5, 0 } } };
  const PointOrigin origin =
    ComposeOrigin({ first, second, PointOrigin::Input(8) }, { 0.25, 0.5, 0.25 });
  EXPECT_EQ(origin.Points, second.Points);
  EXPECT_EQ(origin.Weights, second.Weights);
}
