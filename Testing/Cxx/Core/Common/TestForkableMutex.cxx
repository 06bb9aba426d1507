// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/ForkableMutex.h"

#include "Support/ForkedProcess.h"

#include <gtest/gtest.h>

#include <future>
#include <thread>

using namespace insideout;

TEST(ForkableMutex, LetsOneThreadInAtATime)
{
  ForkableMutex mutex;
  int count = 0;
  const auto work = [&]
  {
    for (int turn = 0; turn < 10000; ++turn)
    {
      const std::lock_guard<ForkableMutex> lock(mutex);
      ++count;
    }
  };
  std::thread other(work);
  work();
  other.join();
  EXPECT_EQ(count, 20000);
}

TEST(ForkableMutex, IsFreeInAForkedProcessThoughAnotherThreadHoldsIt)
{
  SKIP_WHERE_FORKS_HANG();
  ForkableMutex mutex;
  std::promise<void> held;
  std::promise<void> done; // by the child
  std::thread other(
    [&]
    {
      const std::lock_guard<ForkableMutex> lock(mutex);
      held.set_value();
      done.get_future().wait();
    });
  held.get_future().wait();
  const auto locksTwice = [&]
  {
    for (int turn = 0; turn < 2; ++turn)
    {
      const std::lock_guard<ForkableMutex> lock(mutex);
    }
    return true;
  };
  EXPECT_TRUE(testprocesses::IsTrueInChild(
    [&] { return locksTwice() && testprocesses::IsTrueInChild(locksTwice); }));
  done.set_value();
  other.join();
}
