// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/FaceTable.h"

#include "Common/Team.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <random>
#include <set>
#include <vector>

using namespace insideout;

TEST(SortedTriangle, KnowsAnOddOrderFromAnEvenOne)
{
  // Large ids, too, which fill all bits but the sign.
  const std::array<Id, 3> ids = { { 3, 70000, 2147483646 } };
  for (const Triangle& even :
    { Triangle{ { 0, 1, 2 } }, Triangle{ { 1, 2, 0 } }, Triangle{ { 2, 0, 1 } } })
  {
    const Triangle t = { { ids[even[0]], ids[even[1]], ids[even[2]] } };
    const SortedTriangle sorted(t);
    EXPECT_EQ(sorted.Points, ids);
    EXPECT_FALSE(sorted.Turned);
    const SortedTriangle turned(Triangle{ { t[0], t[2], t[1] } });
    EXPECT_EQ(turned.Points, ids);
    EXPECT_TRUE(turned.Turned);
  }
}

TEST(SortedTriangle, TakesEqualIds)
{
  EXPECT_EQ(SortedTriangle({ 5, 2, 5 }).Points, (Triangle{ { 2, 5, 5 } }));
  EXPECT_EQ(SortedTriangle({ 2, 5, 2 }).Points, (Triangle{ { 2, 2, 5 } }));
  EXPECT_EQ(SortedTriangle({ 4, 4, 4 }).Points, (Triangle{ { 4, 4, 4 } }));
}

TEST(FaceTable, HasTheFacesOfAllCellsAndNoOther)
{
  constexpr int points = 12;
  std::mt19937 random(1);
  std::vector<Tetrahedron> cells;
  std::multiset<Triangle> faces;
  while (cells.size() < 60)
  {
    Tetrahedron cell;
    for (Id& corner : cell)
    {
      corner = static_cast<Id>(random() % points);
    }
    if (std::set<Id>(cell.begin(), cell.end()).size() == 4)
    {
      cells.push_back(cell);
      for (int k = 0; k < 4; ++k)
      {
        faces.insert(
          SortedTriangle({ cell[(k + 1) % 4], cell[(k + 2) % 4], cell[(k + 3) % 4] }).Points);
      }
    }
  }
  const FaceTable table(points, cells);
  for (Id a = 0; a < points; ++a)
  {
    for (Id b = a + 1; b < points; ++b)
    {
      for (Id c = b + 1; c < points; ++c)
      {
        const FaceTable::Range found = table.Find(SortedTriangle({ c, a, b }));
        EXPECT_EQ(
          found.Last - found.First, static_cast<long>(faces.count(Triangle{ { a, b, c } })));
        for (const FaceEntry& entry : found)
        {
          const std::array<int, 3>& corners = TetrahedronFaces[entry.Face];
          const Tetrahedron& cell = cells[entry.Cell];
          const SortedTriangle face({ cell[corners[0]], cell[corners[1]], cell[corners[2]] });
          EXPECT_EQ(face.Points, (Triangle{ { a, b, c } }));
          EXPECT_EQ(face.Turned, entry.Turned);
          EXPECT_EQ(entry.Middle(), b);
          EXPECT_EQ(entry.Highest(), c);
        }
      }
    }
  }
}

TEST(FaceTable, TellsOfTheFirstFaceThatIsWrongOnAnyNumberOfThreads)
{
  const WholeTeams teams;
  const Id count = 4000;
  std::vector<Tetrahedron> cells;
  for (Id p = 0; p + 3 < count; ++p)
  {
    cells.push_back({ { p, p + 1, p + 2, p + 3 } });
  }
  const FaceTable table(count, cells);
  std::atomic<int> faces{ 0 };
  table.ForEach([&](const FaceTable::Range&, Id) { ++faces; });
  EXPECT_EQ(faces, 3 * (count - 3) + 1);
  for (const Id wrong : { 0, 1500, 3990 })
  {
    const auto visit = [wrong](const FaceTable::Range&, Id lowest)
    {
      if (lowest >= wrong)
      {
        throw lowest;
      }
    };
    try
    {
      table.ForEach(visit);
      ADD_FAILURE();
    }
    catch (Id thrown)
    {
      EXPECT_EQ(thrown, wrong);
    }
  }
}
