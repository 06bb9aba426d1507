// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/Team.h"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <omp.h>
#include <thread>

namespace insideout
{
namespace
{
/** Another thread costs 10,000 to ask and begins 50,000 later, and how much there is to do is a
 * guess. */
constexpr double NanosecondsPerThread = 250000;

bool AreTeamsWhole = false;
thread_local bool IsInTeam = false;

/** Sets IsInTeam, for a while. */
class Membership
{
public:
  Membership() { IsInTeam = true; }
  ~Membership() { IsInTeam = false; }
  Membership(const Membership&) = delete;
  Membership& operator=(const Membership&) = delete;
};

/** What a team knows of itself; its threads share it, for some may come when the others are gone.
 */
class Roll
{
public:
  /** @param[in] wanted how many have to come before any of them begins */
  explicit Roll(int wanted)
    : Wanted(wanted)
  {
  }

  /** @return false where it is too late */
  bool Come()
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    if (this->IsOver)
    {
      return false;
    }
    ++this->Present;
    ++this->Came;
    this->Changed.notify_all();
    this->Changed.wait(lock, [&] { return this->Came >= this->Wanted; });
    return true;
  }

  void Want(int wanted)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Wanted = wanted;
    this->Changed.notify_all();
  }

  void Leave()
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    --this->Present;
    this->Changed.notify_all();
  }

  /** Waits for those that came; nobody else may. */
  void End()
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    this->IsOver = true;
    this->Changed.wait(lock, [&] { return this->Present == 0; });
  }

private:
  std::mutex Mutex;
  std::condition_variable Changed;
  int Wanted;
  int Came = 0;
  int Present = 0;
  bool IsOver = false;
};

/** @return how many threads could be asked to come */
int AskOthers(int others, const std::shared_ptr<Roll>& roll, const std::function<void()>& work)
{
  for (int i = 0; i < others; ++i)
  {
    try
    {
      std::thread(
        [roll, &work]
        {
          if (roll->Come())
          {
            const Membership membership;
            work();
            roll->Leave();
          }
        })
        .detach();
    }
    catch (const std::exception&)
    {
      return i; // no more threads, or no memory for one: those that were asked must be waited for
    }
  }
  return others;
}
} // namespace

int TeamSize(double nanoseconds)
{
  if (IsInTeam || omp_in_parallel())
  {
    return 1;
  }
  const int most = omp_get_max_threads();
  const double worth = AreTeamsWhole ? most : nanoseconds / NanosecondsPerThread;
  return static_cast<int>(std::min(std::max(worth, 1.0), static_cast<double>(most)));
}

void WorkAsTeam(int threads, const std::function<void()>& work)
{
  if (threads <= 1)
  {
    work();
    return;
  }
  const auto roll = std::make_shared<Roll>(AreTeamsWhole ? threads : 1);
  const int others = AskOthers(threads - 1, roll, work);
  roll->Want(AreTeamsWhole ? others + 1 : 1);
  roll->Come();
  {
    const Membership membership;
    work();
  }
  roll->Leave();
  roll->End();
}

WholeTeams::WholeTeams()
{
  AreTeamsWhole = true;
}

WholeTeams::~WholeTeams()
{
  AreTeamsWhole = false;
}
} // namespace insideout
