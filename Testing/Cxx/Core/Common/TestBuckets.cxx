// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/Buckets.h"

#include "Common/Team.h"
#include "Support/AllowedThreads.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <utility>
#include <vector>

using namespace insideout;

TEST(Buckets, HoldAllValuesInTheirOrder)
{
  std::mt19937 random(1);
  for (std::size_t count = 0; count < 30; ++count)
  {
    std::vector<std::pair<std::size_t, int>> given;
    std::vector<std::vector<int>> expected(count);
    for (int value = 0; count > 0 && value < 100; ++value)
    {
      // Some buckets stay empty, the first or the last one among them.
      const std::size_t bucket = (random() % count) / 2 * 2 + (count % 4 == 3 ? 1 : 0);
      if (bucket < count)
      {
        given.emplace_back(bucket, value);
        expected[bucket].push_back(value);
      }
    }
    const Buckets<int> buckets(count,
      [&](auto visit)
      {
        for (const auto& [bucket, value] : given)
        {
          visit(bucket, value);
        }
      });
    ASSERT_EQ(buckets.Size(), count);
    for (std::size_t bucket = 0; bucket < count; ++bucket)
    {
      const Buckets<int>::Range found = buckets[bucket];
      EXPECT_EQ(std::vector<int>(found.begin(), found.end()), expected[bucket]);
      EXPECT_EQ(found.Size(), expected[bucket].size());
    }
  }
}

TEST(Buckets, AreSortedOneByOne)
{
  Buckets<int> buckets(3,
    [](auto visit)
    {
      for (int value = 0; value < 12; ++value)
      {
        visit(static_cast<std::size_t>(value % 3), value);
      }
    });
  buckets.Sort(1, std::greater<int>());
  EXPECT_EQ(
    std::vector<int>(buckets[0].begin(), buckets[0].end()), (std::vector<int>{ 0, 3, 6, 9 }));
  EXPECT_EQ(
    std::vector<int>(buckets[1].begin(), buckets[1].end()), (std::vector<int>{ 10, 7, 4, 1 }));
  EXPECT_EQ(
    std::vector<int>(buckets[2].begin(), buckets[2].end()), (std::vector<int>{ 2, 5, 8, 11 }));
}

TEST(Buckets, AreTheSameOnAnyNumberOfThreadsOnceTheyAreSorted)
{
  constexpr std::size_t Elements = 1000;
  const auto forElement = [](std::size_t i, const auto& visit)
  {
    for (std::size_t k = 0; k < i % 4; ++k)
    {
      visit((i * i + k) % 37, 4 * i + k);
    }
  };
  const Buckets<std::size_t> expected(40,
    [&](const auto& visit)
    {
      for (std::size_t i = 0; i < Elements; ++i)
      {
        forElement(i, visit);
      }
    });
  const WholeTeams teams;
  for (const int threads : { 1, 2, 8 })
  {
    const testthreads::Allowed allowed(threads);
    auto found = Buckets<std::size_t>::Unordered(40, Elements, 1, forElement);
    ASSERT_EQ(found.Size(), expected.Size());
    for (std::size_t bucket = 0; bucket < found.Size(); ++bucket)
    {
      found.Sort(bucket, std::less<>());
      EXPECT_EQ(std::vector<std::size_t>(found[bucket].begin(), found[bucket].end()),
        std::vector<std::size_t>(expected[bucket].begin(), expected[bucket].end()));
    }
  }
}

TEST(Buckets, AreNoneAtFirst)
{
  EXPECT_EQ(Buckets<int>().Size(), 0u);
}
