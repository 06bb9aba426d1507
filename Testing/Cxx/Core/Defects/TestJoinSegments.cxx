// SPDX-License-Identifier: GPL-3.0-or-later
#include "Defects/JoinSegments.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

using namespace insideout;

using Lines = std::vector<std::vector<Id>>;

TEST(JoinSegments, GoesFromTheLowerEndToTheOther)
{
  EXPECT_EQ(JoinSegments({ { 4, 2 }, { 0, 4 }, { 2, 7 } }), (Lines{ { 0, 4, 2, 7 } }));
  EXPECT_EQ(JoinSegments({}), Lines{});
}

TEST(JoinSegments, RepeatsTheFirstPointOfALoop)
{
  EXPECT_EQ(JoinSegments({ { 3, 5 }, { 1, 5 }, { 1, 3 } }), (Lines{ { 1, 5, 3, 1 } }));
}

TEST(JoinSegments, EndsWhereMoreThanTwoMeet)
{
  // A loop with a tail, and a loop of its own.
  const Lines lines =
    JoinSegments({ { 0, 1 }, { 1, 2 }, { 2, 0 }, { 2, 3 }, { 6, 5 }, { 5, 4 }, { 4, 6 } });
  EXPECT_EQ(lines, (Lines{ { 2, 1, 0, 2 }, { 2, 3 }, { 4, 5, 6, 4 } }));
}

TEST(JoinSegments, TakesEverySegmentOnceAndGoesAsFarAsItCan)
{
  for (unsigned seed = 0; seed < 200; ++seed)
  {
    std::mt19937 random(seed);
    std::set<std::array<Id, 2>> given;
    for (int i = 0; i < 30; ++i)
    {
      const Id p = static_cast<Id>(random() % 25);
      const Id q = static_cast<Id>(random() % 25);
      if (p < q)
      {
        given.insert({ p, q });
      }
    }
    std::map<Id, int> degree;
    for (const auto& segment : given)
    {
      ++degree[segment[0]];
      ++degree[segment[1]];
    }
    std::set<std::array<Id, 2>> taken;
    for (const std::vector<Id>& line : JoinSegments({ given.begin(), given.end() }))
    {
      ASSERT_GE(line.size(), 2u);
      for (std::size_t i = 1; i < line.size(); ++i)
      {
        const auto ends = std::minmax(line[i - 1], line[i]);
        ASSERT_TRUE(taken.insert({ ends.first, ends.second }).second) << "taken twice";
      }
      for (std::size_t i = 1; i + 1 < line.size(); ++i)
      {
        ASSERT_EQ(degree[line[i]], 2);
      }
      if (line.front() != line.back())
      {
        ASSERT_NE(degree[line.front()], 2);
        ASSERT_NE(degree[line.back()], 2);
      }
    }
    ASSERT_EQ(taken, given);
  }
}
