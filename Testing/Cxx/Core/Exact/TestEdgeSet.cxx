// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/EdgeSet.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <utility>
#include <vector>

using namespace insideout;

TEST(EdgeSet, HasTheEdgesAddedSinceItsStartInBothDirections)
{
  EdgeSet edges;
  std::mt19937 random(1);
  for (const std::size_t most : std::vector<std::size_t>{ 5, 500, 20, 500 })
  {
    edges.Start(most);
    std::set<std::pair<Id, Id>> added;
    while (added.size() < most)
    {
      const Id u = static_cast<Id>(random() % 60);
      const Id v = static_cast<Id>(random() % 60);
      edges.Add(u, v);
      added.insert(std::minmax(u, v));
    }
    for (Id u = 0; u < 60; ++u)
    {
      for (Id v = 0; v < 60; ++v)
      {
        EXPECT_EQ(edges.Has(u, v), added.count(std::minmax(u, v)) > 0);
      }
    }
  }
}
