// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/JobsAtOnce.h"

#include "Common/Team.h"
#include "Support/AllowedThreads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <thread>

namespace
{
using namespace insideout;

constexpr const char* Stage = "working";
const std::vector<int> NumbersOfThreads = { 1, 2, 8 };

/** Allows this number of reports, which come from one thread, of one stage, and ascend. */
class Counting : public Monitor
{
public:
  explicit Counting(int allowed = std::numeric_limits<int>::max())
    : Allowed(allowed)
  {
  }

  bool Continue(const char* stage, double fraction) override
  {
    EXPECT_EQ(std::this_thread::get_id(), this->Thread);
    EXPECT_STREQ(stage, Stage);
    EXPECT_GE(fraction, this->Last);
    EXPECT_LE(fraction, 1);
    this->Last = fraction;
    return ++this->Reports <= this->Allowed;
  }

  double Last = 0;
  int Reports = 0;

private:
  const int Allowed;
  const std::thread::id Thread = std::this_thread::get_id();
};

void WorkUntilStopped(Monitor& own)
{
  for (;;)
  {
    own.Check(Stage, 0);
  }
}
} // namespace

TEST(JobsAtOnce, EachIsDoneOnce)
{
  for (const int threads : NumbersOfThreads)
  {
    const testthreads::Allowed allowed(threads);
    std::vector<std::atomic<int>> done(100);
    Counting monitor;
    JobsAtOnce(
      std::vector<double>(100, 1.0), threads, Stage,
      [&](std::size_t job, Monitor&) { ++done[job]; }, monitor);
    EXPECT_TRUE(std::all_of(done.begin(), done.end(), [](int times) { return times == 1; }));
    EXPECT_NEAR(monitor.Last, 1, 1e-6);
  }
}

TEST(JobsAtOnce, NoneIsNothingToDo)
{
  Counting monitor;
  JobsAtOnce(
    {}, 8, Stage, [](std::size_t, Monitor&) { FAIL(); }, monitor);
}

TEST(JobsAtOnce, TheLargestBeginFirst)
{
  std::vector<std::size_t> begun;
  Counting monitor;
  JobsAtOnce(
    { 1, 3, 2, 3 }, 1, Stage, [&](std::size_t job, Monitor&) { begun.push_back(job); }, monitor);
  EXPECT_EQ(begun, (std::vector<std::size_t>{ 1, 3, 2, 0 }));
}

TEST(JobsAtOnce, ProgressIsThatOfTheStageByTheJobsSizes)
{
  Counting monitor;
  JobsAtOnce(
    { 3, 1 }, 1, Stage,
    [&](std::size_t job, Monitor& own)
    {
      const double before = job == 0 ? 0 : 0.75;
      own.Check("reading", 1);
      EXPECT_NEAR(monitor.Last, before, 1e-6);
      own.Check(Stage, 0.5);
      EXPECT_NEAR(monitor.Last, before + (job == 0 ? 0.375 : 0.125), 1e-6);
      own.Check(Stage, 0.25); // no step back
    },
    monitor);
  EXPECT_NEAR(monitor.Last, 1, 1e-6);
}

TEST(JobsAtOnce, TheFirstErrorInTheOrderOfWorkIsThrown)
{
  const std::vector<double> sizes = { 1, 1, 5, 1, 5, 1, 1, 1 };
  for (const int threads : NumbersOfThreads)
  {
    const testthreads::Allowed allowed(threads);
    for (int round = 0; round < 20; ++round)
    {
      Counting monitor;
      try
      {
        JobsAtOnce(
          sizes, threads, Stage,
          [](std::size_t job, Monitor&)
          {
            if (job != 2 && job != 0)
            {
              throw Error(ErrorCode::Inconsistent, std::to_string(job));
            }
          },
          monitor);
        FAIL() << "no error";
      }
      catch (const Error& error)
      {
        EXPECT_STREQ(error.what(), "4") << threads << " threads";
      }
    }
  }
}

TEST(JobsAtOnce, AFailureEndsThoseThatBeginAfterIt)
{
  for (const int threads : NumbersOfThreads)
  {
    const testthreads::Allowed allowed(threads);
    const WholeTeams whole; // all threads begin before any has failed
    Counting monitor;
    try
    {
      JobsAtOnce(
        std::vector<double>(20, 1.0), threads, Stage,
        [](std::size_t job, Monitor& own)
        {
          if (job == 0)
          {
            throw Error(ErrorCode::TooLarge, "the first");
          }
          WorkUntilStopped(own);
        },
        monitor);
      FAIL() << "no error";
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.Code, ErrorCode::TooLarge);
    }
  }
}

TEST(JobsAtOnce, AStopReachesAllThreads)
{
  for (const int threads : NumbersOfThreads)
  {
    const testthreads::Allowed allowed(threads);
    for (const int reports : { 0, 1, 100 })
    {
      Counting monitor(reports);
      try
      {
        JobsAtOnce(
          std::vector<double>(20, 1.0), threads, Stage,
          [](std::size_t, Monitor& own) { WorkUntilStopped(own); }, monitor);
        FAIL() << "went on";
      }
      catch (const Error& error)
      {
        EXPECT_EQ(error.Code, ErrorCode::Stopped);
      }
      EXPECT_EQ(monitor.Reports, reports + 1) << "asked again after it had stopped them";
    }
  }
}
