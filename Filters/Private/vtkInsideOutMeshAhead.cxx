// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkInsideOutMeshAhead.h"

#include "Common/Stages.h"
#include "Common/Team.h"
#include "vtkInsideOutHull.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <unistd.h>

using namespace insideout;

namespace
{
/** The monitor of all threads: the one that called tells how many hulls are done, and hears whether
 * to stop; the others ask whether it did. */
class SharedMonitor : public Monitor
{
public:
  SharedMonitor(Monitor& caller, std::size_t hulls)
    : Caller(caller)
    , Hulls(hulls)
  {
  }

  bool Continue(const char*, double) override
  {
    const double part = static_cast<double>(this->Done) / this->Hulls;
    if (this->IsCaller() && !this->Caller.Continue(Stages::Tetrahedralizing, part))
    {
      this->IsStopped = true;
    }
    return !this->IsStopped;
  }

  void CountOne()
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    ++this->Done;
    this->Changed.notify_all();
  }

  /** The caller, who has nothing left to do, listens while others work; but not in a process that
   * was forked meanwhile, where there are no others. */
  void Wait()
  {
    constexpr std::chrono::milliseconds Silence(50);
    std::unique_lock<std::mutex> lock(this->Mutex);
    while (this->IsCaller() && this->Done < this->Hulls && getpid() == this->Process)
    {
      this->Changed.wait_for(lock, Silence);
      lock.unlock();
      this->Continue("", 0);
      lock.lock();
    }
  }

private:
  bool IsCaller() const { return std::this_thread::get_id() == this->CallingThread; }

  Monitor& Caller;
  const std::size_t Hulls;
  const std::thread::id CallingThread = std::this_thread::get_id();
  const pid_t Process = getpid();
  std::atomic<bool> IsStopped{ false };
  std::atomic<std::size_t> Done{ 0 };
  std::mutex Mutex;
  std::condition_variable Changed;
};
} // namespace

void vtkInsideOutMeshAhead(const std::vector<std::shared_ptr<vtkInsideOutHull>>& hulls,
  const HullMeshParameters& parameters, bool fill, int threads, Monitor& monitor)
{
  if (hulls.empty())
  {
    return;
  }
  SharedMonitor shared(monitor, hulls.size());
  std::atomic<std::size_t> next{ 0 };
  const auto work = [&]()
  {
    for (std::size_t i = next++; i < hulls.size(); i = next++)
    {
      try
      {
        hulls[i]->Resolve(parameters, shared);
        if (fill)
        {
          hulls[i]->Fill(parameters, shared);
        }
      }
      catch (...)
      {
        hulls[i]->Failure = std::current_exception();
      }
      shared.CountOne();
    }
    shared.Wait();
  };
  WorkAsTeam(std::min({ threads, AllowedThreads(), static_cast<int>(hulls.size()) }), work);
  shared.Check(Stages::Tetrahedralizing, 1);
}
