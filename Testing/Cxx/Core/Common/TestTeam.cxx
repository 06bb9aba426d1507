// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/Team.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

using namespace insideout;

namespace
{
/** While it lives, so many threads are allowed. */
class Allowed
{
public:
  explicit Allowed(int threads)
    : Before(omp_get_max_threads())
  {
    omp_set_num_threads(threads);
  }
  ~Allowed() { omp_set_num_threads(this->Before); }
  Allowed(const Allowed&) = delete;
  Allowed& operator=(const Allowed&) = delete;

private:
  const int Before;
};

/** Where threads wait until so many have met. */
class MeetingPlace
{
public:
  void Meet(int threads)
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    ++this->Present;
    this->Changed.notify_all();
    this->Changed.wait(lock, [&] { return this->Present >= threads; });
  }

  int Present = 0;

private:
  std::mutex Mutex;
  std::condition_variable Changed;
};

constexpr double Little = 1e5; // nanoseconds
constexpr double Much = 1e9;
} // namespace

TEST(Team, IsOneThreadForLittleAndAllForMuch)
{
  const Allowed eight(8);
  EXPECT_EQ(TeamSize(0), 1);
  EXPECT_EQ(TeamSize(Little), 1);
  EXPECT_EQ(TeamSize(Much), 8);
}

TEST(Team, GrowsWithTheWork)
{
  const Allowed many(64);
  int last = 1;
  for (double work = Little; work < Much; work *= 1.5)
  {
    EXPECT_GE(TeamSize(work), last);
    last = TeamSize(work);
  }
  EXPECT_EQ(last, 64);
}

TEST(Team, IsNoMoreThanOpenMPAllows)
{
  const Allowed one(1);
  EXPECT_EQ(TeamSize(Much), 1);
}

TEST(Team, HasAsManyThreadsAsAreAskedFor)
{
  MeetingPlace place;
  WorkAsTeam(8, [&] { place.Meet(8); }); // or it would never end
  EXPECT_EQ(place.Present, 8);
}

TEST(Team, IsOneThreadWithinAnother)
{
  const Allowed eight(8);
  MeetingPlace place;
  int sizes[2] = { 0, 0 };
  std::atomic<int> next{ 0 };
  WorkAsTeam(2,
    [&]
    {
      place.Meet(2);
      sizes[next++] = TeamSize(Much);
    });
  EXPECT_EQ(sizes[0], 1);
  EXPECT_EQ(sizes[1], 1);
  EXPECT_EQ(TeamSize(Much), 8);
#pragma omp parallel num_threads(2)
  {
#pragma omp master
    sizes[0] = TeamSize(Much);
  }
  EXPECT_EQ(sizes[0], 1);
}

/** The caller does all there is; whoever comes later finds that out by itself. */
TEST(Team, IsNotWaitedForByItsCaller)
{
  const std::thread::id caller = std::this_thread::get_id();
  for (int turn = 0; turn < 1000; ++turn)
  {
    std::atomic<int> next{ 0 };
    std::atomic<int> done{ 0 };
    WorkAsTeam(3,
      [&]
      {
        while (next++ < 10)
        {
          ++done;
        }
      });
    ASSERT_EQ(done, 10);
    ASSERT_EQ(std::this_thread::get_id(), caller);
  }
}

TEST(Team, IsCompleteFromTheBeginningWhereTestsAskForThat)
{
  const Allowed four(4);
  const WholeTeams teams;
  EXPECT_EQ(TeamSize(0), 4);
  for (int turn = 0; turn < 100; ++turn)
  {
    std::atomic<int> calls{ 0 };
    WorkAsTeam(4, [&] { ++calls; });
    ASSERT_EQ(calls, 4);
  }
}
