// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/CountedBoundary.h"

#include "Common/Team.h"

#include <gtest/gtest.h>

#include <map>
#include <omp.h>
#include <random>

using namespace insideout;

TEST(CountedBoundary, IsTheSumOfAllEdgesForAnyNumberOfThreads)
{
  const Id points = 500;
  std::mt19937 random(1);
  std::vector<CountedTriangle> triangles;
  std::map<std::pair<Id, Id>, std::int64_t> sum;
  while (triangles.size() < 20000)
  {
    const Id a = static_cast<Id>(random() % points);
    const Triangle t = { { a, (a + 1) % points, static_cast<Id>(random() % points) } };
    if (t[2] == t[0] || t[2] == t[1])
    {
      continue;
    }
    triangles.push_back({ t, static_cast<int>(random() % 3) - 1 });
    for (int k = 0; k < 3; ++k)
    {
      const Id from = t[k];
      const Id to = t[(k + 1) % 3];
      sum[std::minmax(from, to)] += from < to ? triangles.back().Count : -triangles.back().Count;
    }
  }
  const WholeTeams teams;
  const int threads = omp_get_max_threads();
  for (const int number : { 1, 2, 3, 7 })
  {
    omp_set_num_threads(number);
    const std::vector<CountedEdge> boundary = CountedBoundary(triangles, points);
    auto edge = boundary.begin();
    for (const auto& [ends, count] : sum)
    {
      if (count != 0)
      {
        ASSERT_NE(edge, boundary.end());
        EXPECT_EQ(edge->From, ends.first);
        EXPECT_EQ(edge->To, ends.second);
        EXPECT_EQ(edge->Count, count);
        ++edge;
      }
    }
    EXPECT_EQ(edge, boundary.end());
  }
  omp_set_num_threads(threads);
}
