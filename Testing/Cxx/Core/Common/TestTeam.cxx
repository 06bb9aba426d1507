// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/Error.h"
#include "Common/Team.h"
#include "Support/AllowedThreads.h"
#include "Support/ForkedProcess.h"

#include <gtest/gtest.h>

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

using namespace insideout;
using testthreads::Allowed;

namespace
{
/** A barrier: threads wait until this number has arrived. */
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
  const Allowed four(4);
  EXPECT_EQ(TeamSize(0), 1);
  EXPECT_EQ(TeamSize(Little), 1);
  EXPECT_EQ(TeamSize(Much), 4);
}

TEST(Team, GrowsWithTheWork)
{
  const Allowed many(MostThreads());
  int last = 1;
  for (double work = Little; work < Much * MostThreads(); work *= 1.5)
  {
    EXPECT_GE(TeamSize(work), last);
    last = TeamSize(work);
  }
  EXPECT_EQ(last, MostThreads());
}

TEST(Team, IsNoMoreThanFourForEachProcessorHoweverManyAreAskedFor)
{
  EXPECT_EQ(MostThreads() % 4, 0);
  EXPECT_GE(MostThreads(), 4);
  for (const int asked : { MostThreads() + 1, 30000, 100000 })
  {
    const Allowed many(asked);
    EXPECT_EQ(AllowedThreads(), MostThreads());
    EXPECT_EQ(TeamSize(Much * MostThreads()), MostThreads());
    EXPECT_EQ(TooManyThreads().find(std::to_string(asked) + " threads are asked for, but " +
                std::to_string(MostThreads()) + " work"),
      0U)
      << TooManyThreads();
  }
  const Allowed most(MostThreads());
  EXPECT_EQ(TooManyThreads(), "");
}

TEST(Team, IsNoMoreThanOpenMPAllows)
{
  const Allowed one(1);
  EXPECT_EQ(TeamSize(Much), 1);
}

TEST(Team, IsNoMoreThanTheHostAllows)
{
  const Allowed four(4);
  SetHostLimit([] { return 1; });
  EXPECT_EQ(TeamSize(Much), 1);
  SetHostLimit([] { return 3; });
  EXPECT_EQ(AllowedThreads(), 3);
  SetHostLimit([] { return 30000; });
  EXPECT_EQ(AllowedThreads(), 4);
  EXPECT_EQ(TooManyThreads(), "");
  SetHostLimit([] { return 0; });
  EXPECT_EQ(AllowedThreads(), 4);
}

TEST(Team, HasAsManyThreadsAsAreAskedFor)
{
  MeetingPlace place;
  WorkAsTeam(8, [&] { place.Meet(8); }); // or it would never end
  EXPECT_EQ(place.Present, 8);
}

TEST(Team, IsOneThreadWithinAnother)
{
  const Allowed four(4);
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
  EXPECT_EQ(TeamSize(Much), 4);
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

TEST(Team, WorksInAForkedProcessAndInOneThatIsForkedThere)
{
  SKIP_WHERE_FORKS_HANG();
  const auto works = []
  {
    MeetingPlace place;
    WorkAsTeam(4, [&] { place.Meet(4); });
    return place.Present == 4;
  };
  EXPECT_TRUE(works());
  EXPECT_TRUE(
    testprocesses::IsTrueInChild([&] { return works() && testprocesses::IsTrueInChild(works); }));
}

TEST(Team, WorksInAProcessThatIsForkedWhileAnotherThreadIsAtWork)
{
  SKIP_WHERE_FORKS_HANG();
  MeetingPlace begun;
  MeetingPlace done;
  std::thread other(
    [&]
    {
      WorkAsTeam(2,
        [&]
        {
          begun.Meet(3);
          done.Meet(3);
        });
    });
  begun.Meet(3);
  EXPECT_TRUE(testprocesses::IsTrueInChild(
    []
    {
      MeetingPlace place;
      WorkAsTeam(4, [&] { place.Meet(4); });
      return place.Present == 4;
    }));
  done.Meet(3);
  other.join();
}

/** As a monitor might that is asked within a loop. */
TEST(Team, IsAnErrorInAProcessThatTheWorkItselfForks)
{
  SKIP_WHERE_FORKS_HANG();
  const std::thread::id caller = std::this_thread::get_id();
  const pid_t parent = getpid();
  MeetingPlace place;
  bool worked = false;
  const auto work = [&]
  {
    place.Meet(2);
    if (std::this_thread::get_id() == caller)
    {
      const auto forksAndGoesOn = [&]
      {
        worked = TeamSize(Much) == 1;
        return worked;
      };
      EXPECT_TRUE(testprocesses::IsTrueInChild(forksAndGoesOn));
      const pid_t child = fork();
      if (child == 0)
      {
        testprocesses::EndWithParent();
      }
      int status = 0;
      worked = child == 0 || (waitpid(child, &status, 0) == child && status == 0);
    }
  };
  bool isError = false;
  try
  {
    WorkAsTeam(2, work);
  }
  catch (const Error& error)
  {
    isError = error.Code == ErrorCode::Forked;
  }
  if (getpid() != parent)
  {
    _exit(isError ? 0 : 1);
  }
  EXPECT_TRUE(worked);
  EXPECT_FALSE(isError);
}
