// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/Team.h"

#include "Common/Error.h"
#include "Common/ThreadLocals.h"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <new>
#include <omp.h>
#include <pthread.h>
#include <thread>
#include <unistd.h>

namespace insideout
{
namespace
{
/** Nanoseconds: another thread costs 10,000 to request and starts 50,000 later. The amount of work
 * is only an estimate. */
constexpr double NanosecondsPerThread = 250000;

/** More gain nothing and take memory: 30,000 threads once stalled a machine. */
constexpr int ThreadsPerProcessor = 4;
const int Processors = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));

bool AreTeamsWhole = false;

int NoLimit()
{
  return 0;
}

int (*HostLimit)() = NoLimit;

int ThreadsAskedFor()
{
  const int limit = HostLimit();
  return limit > 0 ? std::min(limit, omp_get_max_threads()) : omp_get_max_threads();
}

/** Whether a thread is in a team. A thread-local variable would bring along all of CGAL's. */
class MembershipKey
{
public:
  MembershipKey() { pthread_key_create(&this->Key, nullptr); }
  ~MembershipKey() { pthread_key_delete(this->Key); }
  MembershipKey(const MembershipKey&) = delete;
  MembershipKey& operator=(const MembershipKey&) = delete;

  bool IsSet() const { return pthread_getspecific(this->Key) != nullptr; }

  /** @return false without memory for it */
  bool Set(bool isInTeam) { return pthread_setspecific(this->Key, isInTeam ? this : nullptr) == 0; }

private:
  pthread_key_t Key = 0;
};

MembershipKey IsInTeam;

/**
 * Held while a thread is created, and while this process is forked. The C library gives a new
 * thread the stack of an ended one, and frees that one's thread-local variables. A process forked
 * in between has the same stack, and frees the same variables again (glibc 2.36, get_cached_stack).
 */
std::mutex MakesThreadOrForks;

extern "C" void LockOut()
{
  MakesThreadOrForks.lock();
}

extern "C" void LetIn()
{
  MakesThreadOrForks.unlock();
}

const bool ForksBetweenThreads = pthread_atfork(LockOut, LetIn, LetIn) == 0;

/** Sets IsInTeam for its lifetime. */
class Membership
{
public:
  Membership() = default;
  ~Membership() { IsInTeam.Set(false); }
  Membership(const Membership&) = delete;
  Membership& operator=(const Membership&) = delete;

  const bool HasBegun = IsInTeam.Set(true);
};

/** The shared state of a team; owned by its threads, because some may start when the others have
 * ended. */
class Roll
{
public:
  /** @param[in] wanted number of threads that have to arrive before any of them starts work */
  explicit Roll(int wanted)
    : Wanted(wanted)
  {
  }

  /** @return false if it is too late */
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

  /** Arrive, so as not to be waited for, without working. */
  void Miss()
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    ++this->Came;
    this->Changed.notify_all();
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

  /**
   * Whether this process was forked from that of the team. It has no other threads, and any of them
   * may have held the mutex.
   */
  bool IsCopy() const { return getpid() != this->Process; }

  /** Wait for the threads that arrived; no more are admitted. */
  void End()
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    this->IsOver = true;
    this->Changed.wait(lock, [&] { return this->Present == 0; });
  }

private:
  const pid_t Process = getpid();
  std::mutex Mutex;
  std::condition_variable Changed;
  int Wanted;
  int Came = 0;
  int Present = 0;
  bool IsOver = false;
};

/** @return the number of threads that could be requested */
int AskOthers(int others, const std::shared_ptr<Roll>& roll, const std::function<void()>& work)
{
  for (int i = 0; i < others; ++i)
  {
    try
    {
      const std::lock_guard<std::mutex> noFork(MakesThreadOrForks);
      std::thread(
        [roll, &work]
        {
          const Membership membership;
          if (!membership.HasBegun || !AllocateThreadLocalsOfTeam())
          {
            roll->Miss();
          }
          else if (roll->Come())
          {
            work();
            roll->Leave();
          }
        })
        .detach();
    }
    catch (const std::exception&)
    {
      return i; // no more threads, or no memory for one: wait for those that were requested
    }
  }
  return others;
}
} // namespace

int MostThreads()
{
  return ThreadsPerProcessor * Processors;
}

int AllowedThreads()
{
  return std::min(ThreadsAskedFor(), MostThreads());
}

void SetHostLimit(int (*limit)())
{
  HostLimit = limit;
}

std::string TooManyThreads()
{
  const int asked = ThreadsAskedFor();
  return asked <= MostThreads() ? std::string()
                                : std::to_string(asked) + " threads are asked for, but " +
      std::to_string(MostThreads()) + " work: more than " + std::to_string(ThreadsPerProcessor) +
      " for each of the machine's " + std::to_string(Processors) + " processors help nobody";
}

int TeamSize(double nanoseconds)
{
  if (IsInTeam.IsSet() || omp_in_parallel())
  {
    return 1;
  }
  const int most = AllowedThreads();
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
  const Membership membership;
  if (!membership.HasBegun)
  {
    throw std::bad_alloc();
  }
  const auto roll = std::make_shared<Roll>(AreTeamsWhole ? threads : 1);
  const int others = AskOthers(threads - 1, roll, work);
  roll->Want(AreTeamsWhole ? others + 1 : 1);
  roll->Come();
  work();
  if (roll->IsCopy())
  {
    throw Error(ErrorCode::Forked,
      "this process was forked in the middle of the work, and has not the threads to go on with "
      "it");
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
