// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <mutex>
#include <unistd.h>

namespace insideout
{
/**
 * A mutex that is free in a forked process. An ordinary one that another thread holds during the
 * fork stays locked in the copy, which has no such thread to unlock it.
 */
class ForkableMutex
{
public:
  ForkableMutex() = default;
  ForkableMutex(const ForkableMutex&) = delete;
  ForkableMutex& operator=(const ForkableMutex&) = delete;
  ~ForkableMutex() { delete this->Current.load(); }

  void lock()
  {
    OfProcess* mutex = this->Current.load();
    while (mutex->Process != getpid())
    {
      // The parent's mutex is never freed: its state is unknown.
      auto* own = new OfProcess;
      if (this->Current.compare_exchange_strong(mutex, own))
      {
        mutex = own;
      }
      else
      {
        delete own;
      }
    }
    mutex->Mutex.lock();
  }

  /** Called by the thread that holds the lock. */
  void unlock() { this->Current.load()->Mutex.unlock(); }

private:
  struct OfProcess
  {
    const pid_t Process = getpid();
    std::mutex Mutex;
  };

  std::atomic<OfProcess*> Current{ new OfProcess };
};
} // namespace insideout
