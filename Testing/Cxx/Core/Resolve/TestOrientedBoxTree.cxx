// SPDX-License-Identifier: GPL-3.0-or-later
#include "Resolve/OrientedBoxTree.h"

#include "Resolve/MeetBeyondSharedCorners.h"
#include "Support/TestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace insideout;
using namespace testmeshes;

namespace
{
using Pairs = std::vector<std::array<Id, 2>>;

std::vector<Id> OwnSets(const TriangleSoup& soup)
{
  std::vector<Id> sets(soup.Triangles.size());
  std::iota(sets.begin(), sets.end(), 0);
  return sets;
}

/** The pairs that a tree visits, sorted. */
Pairs Visited(const TriangleSoup& soup, const std::vector<Id>& sets)
{
  const OrientedBoxTree tree(soup.Points, soup.Triangles, sets);
  Pairs pairs;
  for (const OrientedBoxTree::Task& task : tree.Tasks(64))
  {
    tree.VisitPairs(task, [&](Id a, Id b) { pairs.push_back({ std::min(a, b), std::max(a, b) }); });
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

Pairs Meeting(const TriangleSoup& soup)
{
  Pairs pairs;
  for (Id j = 0; j < static_cast<Id>(soup.Triangles.size()); ++j)
  {
    for (Id i = 0; i < j; ++i)
    {
      if (MeetBeyondSharedCorners(soup.Points, soup.Triangles[i], soup.Triangles[j]))
      {
        pairs.push_back({ i, j });
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}
} // namespace

TEST(OrientedBoxTree, VisitsEveryPairThatMeetsOnceAtEveryScale)
{
  for (unsigned seed = 0; seed < 24; ++seed)
  {
    TriangleSoup soup = seed % 3 == 0 ? GridSoup(seed, 100, 3)
      : seed % 3 == 1                 ? RandomSoup(seed, 100)
                                      : Join(SlantedFans(10, 10), RandomSoup(seed, 20));
    if (seed % 3 == 2)
    {
      soup.Triangles.push_back({ 0, 1, 6 }); // overlaps needles at the same tip
    }
    const Pairs meeting = Meeting(soup);
    ASSERT_FALSE(meeting.empty()) << "seed " << seed;
    for (const int exponent : { 0, -1000, -500, 500, 1015 }) // squares and sums over- and underflow
    {
      TriangleSoup scaled = soup;
      for (Point& p : scaled.Points)
      {
        p = { std::ldexp(p[0], exponent), std::ldexp(p[1], exponent), std::ldexp(p[2], exponent) };
      }
      const Pairs visited = Visited(scaled, OwnSets(scaled));
      EXPECT_EQ(std::adjacent_find(visited.begin(), visited.end()), visited.end());
      EXPECT_TRUE(std::includes(visited.begin(), visited.end(), meeting.begin(), meeting.end()))
        << "seed " << seed << " scale 2^" << exponent;
    }
  }
}

TEST(OrientedBoxTree, VisitsFewPairsOfNeedlesSideBySide)
{
  const TriangleSoup soup = SlantedFans(40, 40);
  std::vector<Id> fans;
  for (Id f = 0; f < 1600; ++f)
  {
    fans.push_back(f / 40);
  }
  EXPECT_LT(Visited(soup, fans).size(), 16u * 1600u); // bounding boxes: 1.2 million
}

TEST(OrientedBoxTree, VisitsFewPairsOfAFan)
{
  const TriangleSoup soup = SlantedFans(1, 1600);
  EXPECT_LT(Visited(soup, OwnSets(soup)).size(), 16u * 1600u); // bounding boxes: 1.3 million
}

TEST(OrientedBoxTree, VisitsOnlyPairsOfDifferentSets)
{
  const TriangleSoup soup = RandomSoup(1, 200);
  std::vector<Id> sets;
  for (Id f = 0; f < static_cast<Id>(soup.Triangles.size()); ++f)
  {
    sets.push_back(f / 50);
  }
  Pairs expected = Visited(soup, OwnSets(soup));
  expected.erase(std::remove_if(expected.begin(), expected.end(),
                   [&](const auto& pair) { return sets[pair[0]] == sets[pair[1]]; }),
    expected.end());
  EXPECT_FALSE(expected.empty());
  EXPECT_EQ(Visited(soup, sets), expected);
  EXPECT_TRUE(Visited(soup, std::vector<Id>(soup.Triangles.size(), 0)).empty());
}

TEST(OrientedBoxTree, KeepsBoxesThatTouch)
{
  const auto boxAt = [](double x) -> OrientedBox {
    return { { x, 0, 0 }, { { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } }, { 1, 1, 1 }, 1e-12 };
  };
  EXPECT_FALSE(AreApart(boxAt(0), boxAt(2)));
  EXPECT_TRUE(AreApart(boxAt(0), boxAt(2 + 1e-11)));
  OrientedBox turned = boxAt(0);
  turned.Axes = { { { 0.6, 0.8, 0 }, { -0.8, 0.6, 0 }, { 0, 0, 1 } } };
  EXPECT_FALSE(AreApart(turned, boxAt(2.39)));
  EXPECT_TRUE(AreApart(turned, boxAt(2.41)));
}

TEST(OrientedBoxTree, KeepsBoxesThatOverlapSeenFromATip)
{
  const auto boxAt = [](double x) -> OrientedBox {
    return { { x, 0, 10 }, { { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } }, { 1, 1, 0 }, 1e-12 };
  };
  EXPECT_FALSE(AreApartSeenFrom({ 0, 0, 0 }, boxAt(-1), boxAt(1)));
  EXPECT_TRUE(AreApartSeenFrom({ 0, 0, 0 }, boxAt(-1.001), boxAt(1.001)));
  EXPECT_FALSE(AreApartSeenFrom({ 0, 0, 0 }, boxAt(0), boxAt(0)));
}
