// SPDX-License-Identifier: GPL-3.0-or-later
#include "Output/MergePieces.h"

#include "Common/DisjointSets.h"
#include "Common/SortedTriangle.h"
#include "Support/StopAtEveryReport.h"
#include "Support/TestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

namespace
{
using namespace insideout;

using Edge = std::pair<Id, Id>;

Edge EdgeOf(Id a, Id b)
{
  return { std::min(a, b), std::max(a, b) };
}

/** A closed surface whose triangles were cut: at the middle of random edges, and in the interior.
 */
struct CutSurface
{
  std::vector<Triangle> Given;
  std::vector<BoundaryTriangle> Pieces;
  std::map<Edge, std::vector<Id>> Middles; ///< of edges that are cut, from the lower end
  std::vector<Id> Inner;                   ///< per given triangle, or None
};

CutSurface Cut(const std::vector<Triangle>& given, unsigned seed)
{
  std::mt19937 random(seed);
  CutSurface surface;
  surface.Given = given;
  Id next = 1000; // points of the cut, no coordinates are asked for
  for (const Triangle& t : given)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Edge edge = EdgeOf(t[k], t[(k + 1) % 3]);
      if (surface.Middles.count(edge) == 0)
      {
        for (unsigned count = random() % 8 / 5 * (1 + random() % 3); count > 0; --count)
        {
          surface.Middles[edge].push_back(next++);
        }
      }
    }
  }
  for (Id source = 0; source < static_cast<Id>(given.size()); ++source)
  {
    const Triangle& t = given[source];
    std::vector<Id> outline;
    for (int k = 0; k < 3; ++k)
    {
      outline.push_back(t[k]);
      const Edge edge = EdgeOf(t[k], t[(k + 1) % 3]);
      std::vector<Id> middles;
      if (surface.Middles.count(edge) != 0)
      {
        middles = surface.Middles[edge];
      }
      if (t[k] != edge.first)
      {
        std::reverse(middles.begin(), middles.end());
      }
      outline.insert(outline.end(), middles.begin(), middles.end());
    }
    if (outline.size() == 3 && random() % 2 != 0)
    {
      surface.Inner.push_back(None);
      surface.Pieces.push_back({ t, source });
      continue;
    }
    const Id centre = next++;
    surface.Inner.push_back(centre);
    for (std::size_t i = 0; i < outline.size(); ++i)
    {
      surface.Pieces.push_back(
        { { { outline[i], outline[(i + 1) % outline.size()], centre } }, source });
    }
  }
  return surface;
}

/** A ball of 8 x 16 x 2 triangles, closed. */
std::vector<Triangle> Ball()
{
  constexpr Id Rings = 7, Around = 16;
  std::vector<Triangle> triangles;
  const auto at = [](Id ring, Id k) { return 2 + ring * Around + k % Around; };
  for (Id k = 0; k < Around; ++k)
  {
    triangles.push_back({ 0, at(0, k), at(0, k + 1) });
    triangles.push_back({ 1, at(Rings - 1, k + 1), at(Rings - 1, k) });
    for (Id ring = 0; ring + 1 < Rings; ++ring)
    {
      triangles.push_back({ at(ring, k), at(ring + 1, k), at(ring, k + 1) });
      triangles.push_back({ at(ring, k + 1), at(ring + 1, k), at(ring + 1, k + 1) });
    }
  }
  return triangles;
}

bool IsWatertight(const std::vector<BoundaryTriangle>& triangles)
{
  std::map<Edge, int> balance;
  for (const BoundaryTriangle& t : triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Id a = t.Corners[k];
      const Id b = t.Corners[(k + 1) % 3];
      balance[EdgeOf(a, b)] += a < b ? 1 : -1;
    }
  }
  return !balance.empty() &&
    std::all_of(balance.begin(), balance.end(), [](const auto& edge) { return edge.second == 0; });
}

/** The given triangles that are among the result, in their own orientation. */
std::set<Id> Wholes(const CutSurface& surface, const std::vector<BoundaryTriangle>& result)
{
  std::set<Id> wholes;
  for (const BoundaryTriangle& t : result)
  {
    if (t.Source != None)
    {
      const Triangle& given = surface.Given[t.Source];
      const SortedTriangle found(t.Corners);
      const SortedTriangle expected(given);
      if (found.Points == expected.Points)
      {
        EXPECT_EQ(found.Turned, expected.Turned);
        wholes.insert(t.Source);
      }
    }
  }
  return wholes;
}

std::vector<BoundaryTriangle> MergePieces(
  const std::vector<BoundaryTriangle>& triangles, const std::vector<Triangle>& given)
{
  Monitor monitor;
  return MergePieces(triangles, given, monitor, { "extracting", 0, 1 });
}

TEST(MergePieces, PutsEveryTriangleTogetherThatLiesOnTheBoundaryWhole)
{
  for (unsigned seed = 0; seed < 30; ++seed)
  {
    const CutSurface surface = Cut(Ball(), seed);
    EXPECT_GT(surface.Pieces.size(), 2 * surface.Given.size());
    ASSERT_TRUE(IsWatertight(surface.Pieces));
    const std::vector<BoundaryTriangle> result = MergePieces(surface.Pieces, surface.Given);
    ASSERT_EQ(result.size(), surface.Given.size());
    for (std::size_t t = 0; t < result.size(); ++t)
    {
      EXPECT_EQ(result[t].Corners, surface.Given[t]);
      EXPECT_EQ(result[t].Source, static_cast<Id>(t));
    }
  }
}

/**
 * Where one piece of a triangle closes a hole the triangle is not whole, nor is any that is tied to
 * it by cut edges; all others are.
 */
TEST(MergePieces, LeavesWhatIsTiedToAPieceThatIsNotThere)
{
  std::size_t whole = 0;
  std::size_t tied = 0;
  for (unsigned seed = 0; seed < 30; ++seed)
  {
    CutSurface surface = Cut(Ball(), seed);
    std::mt19937 random(seed);
    std::set<Id> damaged;
    for (int i = 0; i < 6; ++i)
    {
      BoundaryTriangle& piece = surface.Pieces[random() % surface.Pieces.size()];
      damaged.insert(piece.Source);
      piece.Source = None;
    }
    damaged.erase(None); // one that was hit twice

    DisjointSets tiedSets(surface.Given.size());
    std::map<Edge, Id> first;
    for (Id t = 0; t < static_cast<Id>(surface.Given.size()); ++t)
    {
      for (int k = 0; k < 3; ++k)
      {
        const Edge edge = EdgeOf(surface.Given[t][k], surface.Given[t][(k + 1) % 3]);
        if (surface.Middles.count(edge) != 0)
        {
          tiedSets.Join(first.insert({ edge, t }).first->second, t);
        }
      }
    }
    std::set<Id> spoiled;
    for (const Id t : damaged)
    {
      spoiled.insert(tiedSets.Find(t));
    }
    std::set<Id> expected;
    for (Id t = 0; t < static_cast<Id>(surface.Given.size()); ++t)
    {
      const bool isLost = damaged.count(t) != 0;
      if (!isLost && spoiled.count(tiedSets.Find(t)) == 0)
      {
        expected.insert(t);
      }
    }
    const std::vector<BoundaryTriangle> result = MergePieces(surface.Pieces, surface.Given);
    EXPECT_TRUE(IsWatertight(result));
    EXPECT_EQ(Wholes(surface, result), expected);
    whole += expected.size();
    tied += surface.Given.size() - expected.size() - damaged.size();
  }
  EXPECT_GT(whole, 100u);
  EXPECT_GT(tied, 100u);
}

TEST(MergePieces, KeepsPointsThatAnotherPartTouches)
{
  for (unsigned seed = 0; seed < 10; ++seed)
  {
    CutSurface surface = Cut(Ball(), seed);
    const auto touched = std::find_if(
      surface.Inner.begin(), surface.Inner.end(), [](Id inner) { return inner != None; });
    const Id source = static_cast<Id>(touched - surface.Inner.begin());
    // A tetrahedron of its own that stands on the triangle with one corner.
    const Triangle corners[] = { { *touched, 5000, 5001 }, { *touched, 5001, 5002 },
      { *touched, 5002, 5000 }, { 5000, 5002, 5001 } };
    for (const Triangle& t : corners)
    {
      surface.Pieces.push_back({ t, None });
    }
    const std::vector<BoundaryTriangle> result = MergePieces(surface.Pieces, surface.Given);
    EXPECT_TRUE(IsWatertight(result));
    EXPECT_EQ(Wholes(surface, result).count(source), 0u);
    EXPECT_LT(result.size(), surface.Pieces.size());
  }
}

TEST(MergePieces, TurnsTheTriangleOutwardWhereTheInputFacedInward)
{
  CutSurface surface = Cut(Ball(), 3);
  for (Triangle& t : surface.Given)
  {
    std::swap(t[1], t[2]);
  }
  const std::vector<Triangle> ball = Ball();
  const std::vector<BoundaryTriangle> result = MergePieces(surface.Pieces, surface.Given);
  ASSERT_EQ(result.size(), ball.size());
  for (std::size_t t = 0; t < ball.size(); ++t)
  {
    EXPECT_EQ(SortedTriangle(result[t].Corners).Points, SortedTriangle(ball[t]).Points);
    EXPECT_EQ(SortedTriangle(result[t].Corners).Turned, SortedTriangle(ball[t]).Turned);
  }
}

TEST(MergePieces, LeavesATriangleThatIsOnTheBoundaryAsAWholeToo)
{
  // A flat tetrahedron on triangle 0 1 2: its pieces above, the whole below.
  const std::vector<BoundaryTriangle> triangles = { { { 0, 1, 3 }, 0 }, { { 1, 2, 3 }, 0 },
    { { 2, 0, 3 }, 0 }, { { 0, 2, 1 }, None } };
  const std::vector<BoundaryTriangle> result = MergePieces(triangles, { { 0, 1, 2 } });
  EXPECT_EQ(result.size(), 4u);
}

TEST(MergePieces, CanBeStopped)
{
  const CutSurface surface = Cut(Ball(), 3);
  const int reports =
    testmeshes::StopAtEveryReport([&](Monitor& monitor, const ProgressRange& range)
      { MergePieces(surface.Pieces, surface.Given, monitor, range); });
  EXPECT_EQ(reports, 5) << "one per loop";
}
} // namespace
