// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/ParallelLoop.h"

#include "Common/Types.h"
#include "Support/StopAtEveryReport.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <condition_variable>
#include <set>
#include <stdexcept>
#include <vector>

using namespace insideout;

namespace
{
constexpr double Cheap = 1; // nanoseconds
constexpr double Dear = 1e9;

/** The threads that worked on a loop; where there is to be a team, none goes on before all came. */
std::set<std::thread::id> ThreadsOf(Id count, double cost, std::size_t expected)
{
  std::set<std::thread::id> threads;
  std::mutex mutex;
  std::condition_variable changed;
  ParallelLoop(count, cost,
    [&](Id)
    {
      std::unique_lock<std::mutex> lock(mutex);
      threads.insert(std::this_thread::get_id());
      changed.notify_all();
      changed.wait(lock, [&] { return threads.size() >= expected; });
    });
  return threads;
}

class ParallelLoopOnThreads : public testing::TestWithParam<int>
{
protected:
  void SetUp() override { omp_set_num_threads(this->GetParam()); }
  void TearDown() override { omp_set_num_threads(this->Before); }

private:
  const int Before = omp_get_max_threads();
};
} // namespace

INSTANTIATE_TEST_SUITE_P(Threads, ParallelLoopOnThreads, testing::Values(1, 2, 8));

TEST_P(ParallelLoopOnThreads, KeepsWhatIsShortOrOnlyOneToItsCaller)
{
  const std::set<std::thread::id> caller = { std::this_thread::get_id() };
  EXPECT_EQ(ThreadsOf(1000, Cheap, 1), caller);
  EXPECT_EQ(ThreadsOf(1, Dear, 1), caller);
  EXPECT_EQ(ThreadsOf(0, Dear, 1), std::set<std::thread::id>());
}

TEST_P(ParallelLoopOnThreads, SharesWhatIsLongAmongAllThreads)
{
  const std::size_t threads = static_cast<std::size_t>(this->GetParam());
  EXPECT_EQ(ThreadsOf(100, Dear, threads).size(), threads);
}

TEST_P(ParallelLoopOnThreads, VisitsEachOnceWhateverItCosts)
{
  for (const Id count : { 0, 1, 2, 7, 1000 })
  {
    for (const double cost : { 0.0, Cheap, 1e3, 1e5, Dear })
    {
      std::vector<std::atomic<int>> visits(static_cast<std::size_t>(count));
      ParallelLoop(count, cost, [&](Id i) { ++visits[static_cast<std::size_t>(i)]; });
      for (const std::atomic<int>& number : visits)
      {
        ASSERT_EQ(number, 1) << count << " of " << cost << " ns";
      }
    }
  }
}

TEST_P(ParallelLoopOnThreads, ThrowsOnWhatABodyThrows)
{
  for (const double cost : { Cheap, Dear })
  {
    const WholeTeams teams;
    const auto loop = [&]
    {
      ParallelLoop(1000, cost,
        [](Id i)
        {
          if (i == 100)
          {
            throw std::runtime_error("out of order");
          }
        });
    };
    EXPECT_THROW(loop(), std::runtime_error);
  }
}

TEST_P(ParallelLoopOnThreads, EndsWhereTheMonitorStopsIt)
{
  struct Stopper : Monitor
  {
    bool Continue(const char*, double) override { return false; }
  };
  Stopper stopper;
  std::atomic<int> done{ 0 };
  try
  {
    ParallelLoop(1000000, Dear, stopper, { "working", 0, 1 },
      [&](Id)
      {
        ++done;
        std::this_thread::yield();
      });
    // Others may have left nothing for the caller.
    EXPECT_EQ(done, 1000000);
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::Stopped);
  }
}

TEST_P(ParallelLoopOnThreads, AsksTheMonitorOnTheCallersThreadOnly)
{
  struct Asked : Monitor
  {
    bool Continue(const char*, double) override
    {
      this->Threads.insert(std::this_thread::get_id());
      return true;
    }
    std::set<std::thread::id> Threads;
  };
  Asked asked;
  const WholeTeams teams;
  ParallelLoop(10000, Dear, asked, { "working", 0, 1 }, [](Id) {});
  for (const std::thread::id& thread : asked.Threads)
  {
    EXPECT_EQ(thread, std::this_thread::get_id());
  }
}

TEST(ParallelLoop, CanBeStoppedAtEveryReport)
{
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1); // so that the reports are always the same
  const int reports = testmeshes::StopAtEveryReport([](Monitor& monitor, const ProgressRange& range)
    { ParallelLoop(10, Dear, monitor, range, [](Id) {}); });
  omp_set_num_threads(threads);
  EXPECT_EQ(reports, 10);
}
