// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/JobsAtOnce.h"

#include "Common/Team.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <limits>
#include <mutex>
#include <numeric>
#include <string_view>
#include <thread>
#include <unistd.h>

namespace insideout
{
namespace
{
/** Progress is counted in integers, which threads add to without a lock. */
constexpr double WholeProgress = 1 << 30;

/** The shared state of the jobs, which are identified by their position in the order of work. */
class JobsTogether
{
public:
  JobsTogether(std::size_t jobs, double size, const char* stage, Monitor& caller)
    : Jobs(jobs)
    , Size(size)
    , Stage(stage)
    , Caller(caller)
    , FirstFailure(jobs)
  {
  }

  /** Whether a job may continue. The calling thread reports the progress of all to its monitor,
   * until that stops them. */
  bool Continue(std::size_t place)
  {
    const double part = std::min(static_cast<double>(this->Progress) / WholeProgress, 1.0);
    if (this->IsCaller() && !this->IsStopped && !this->Caller.Continue(this->Stage, part))
    {
      this->IsStopped = true;
    }
    return !this->IsStopped && place <= this->FirstFailure;
  }

  void Advance(std::int64_t by) { this->Progress += by; }

  void Fail(std::size_t place)
  {
    std::size_t first = this->FirstFailure;
    while (place < first && !this->FirstFailure.compare_exchange_weak(first, place))
    {
    }
  }

  void CountOne()
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    ++this->Done;
    this->Changed.notify_all();
  }

  /** The caller, with no jobs left, waits for the others; but not in a process that was forked
   * meanwhile and has no others. */
  void Wait()
  {
    constexpr std::chrono::milliseconds Silence(50);
    std::unique_lock<std::mutex> lock(this->Mutex);
    while (this->IsCaller() && this->Done < this->Jobs && getpid() == this->Process)
    {
      this->Changed.wait_for(lock, Silence);
      lock.unlock();
      this->Continue(0);
      lock.lock();
    }
  }

  void CheckStopped()
  {
    this->Continue(0);
    if (this->IsStopped)
    {
      throw Error(ErrorCode::Stopped, std::string("stopped while ") + this->Stage);
    }
  }

  const std::size_t Jobs;
  const double Size; ///< of all jobs
  const char* const Stage;

private:
  bool IsCaller() const { return std::this_thread::get_id() == this->CallingThread; }

  Monitor& Caller;
  const std::thread::id CallingThread = std::this_thread::get_id();
  const pid_t Process = getpid();
  std::atomic<bool> IsStopped{ false };
  std::atomic<std::int64_t> Progress{ 0 };
  std::atomic<std::size_t> FirstFailure;
  std::size_t Done = 0;
  std::mutex Mutex;
  std::condition_variable Changed;
};

class JobMonitor : public Monitor
{
public:
  JobMonitor(JobsTogether& all, std::size_t place, double size)
    : All(all)
    , Place(place)
    , Share(all.Size > 0 ? size / all.Size * WholeProgress : 0)
  {
  }

  bool Continue(const char* stage, double fraction) override
  {
    if (std::string_view(stage) == this->All.Stage)
    {
      this->Reach(fraction);
    }
    return this->All.Continue(this->Place);
  }

  /** Report progress; ignored if it is not above that reported before. */
  void Reach(double fraction)
  {
    const auto progress = static_cast<std::int64_t>(this->Share * std::min(fraction, 1.0));
    if (progress > this->Reached)
    {
      this->All.Advance(progress - this->Reached);
      this->Reached = progress;
    }
  }

private:
  JobsTogether& All;
  const std::size_t Place;
  const double Share;
  std::int64_t Reached = 0;
};

/** The jobs, the largest first. */
std::vector<std::size_t> OrderOfWork(const std::vector<double>& sizes)
{
  std::vector<std::size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(
    order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
  return order;
}
} // namespace

void JobsAtOnce(const std::vector<double>& sizes, int threads, const char* stage,
  const std::function<void(std::size_t, Monitor&)>& work, Monitor& monitor)
{
  const std::vector<std::size_t> order = OrderOfWork(sizes);
  JobsTogether all(order.size(), std::accumulate(sizes.begin(), sizes.end(), 0.0), stage, monitor);
  std::vector<std::exception_ptr> failures(order.size()); // by place
  std::atomic<std::size_t> next{ 0 };
  const auto takeJobs = [&]()
  {
    for (std::size_t place = next++; place < order.size(); place = next++)
    {
      JobMonitor own(all, place, sizes[order[place]]);
      try
      {
        if (all.Continue(place))
        {
          work(order[place], own);
        }
      }
      catch (...)
      {
        failures[place] = std::current_exception();
        all.Fail(place);
      }
      own.Reach(1);
      all.CountOne();
    }
    all.Wait();
  };
  const int most = TeamSize(std::numeric_limits<double>::infinity());
  WorkAsTeam(std::min({ threads, most, static_cast<int>(order.size()) }), takeJobs);
  all.CheckStopped();
  for (const std::exception_ptr& failure : failures)
  {
    if (failure)
    {
      std::rethrow_exception(failure);
    }
  }
}
} // namespace insideout
