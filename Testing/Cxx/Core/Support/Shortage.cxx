// SPDX-License-Identifier: GPL-3.0-or-later
#include "Support/Shortage.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <dlfcn.h>
#include <limits>
#include <pthread.h>
#include <sched.h>
#include <unistd.h>

// The C library's own.
extern "C" void* __libc_malloc(std::size_t);
extern "C" void* __libc_calloc(std::size_t, std::size_t);
extern "C" void* __libc_realloc(void*, std::size_t);
extern "C" void* __libc_memalign(std::size_t, std::size_t);

namespace
{
/** Calls are counted from the beginning of the program on, and those of a range fail. */
struct Counted
{
  std::atomic<std::size_t> Calls;
  std::atomic<std::size_t> First; ///< that fails; from 1
  std::atomic<std::size_t> Last;
};

// Zeroes at first, for malloc is called before anything is constructed.
std::array<Counted, 2> Counts;

bool Fails(shortage::Of what)
{
  Counted& counted = Counts[static_cast<std::size_t>(what)];
  const std::size_t call = ++counted.Calls;
  return call >= counted.First && call <= counted.Last;
}

bool IsMemoryShort()
{
  const bool fails = Fails(shortage::Of::Memory);
  errno = fails ? ENOMEM : errno;
  return fails;
}

using CreateThread = int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
std::atomic<bool> AreThreadsSlow;
std::atomic<bool> IsSeen; ///< that a thread is being made
std::atomic<int> ThreadsInTheMaking;

/** Takes until it is seen, and then long enough for a fork. */
void MakeSlowly()
{
  for (int turn = 0; AreThreadsSlow && turn < 100; turn += IsSeen ? 1 : 0)
  {
    usleep(1000);
  }
}

const auto LibraryCreateThread = reinterpret_cast<CreateThread>(dlsym(RTLD_NEXT, "pthread_create"));
} // namespace

// Seen by all libraries, whatever else is hidden.
#pragma GCC visibility push(default)
extern "C"
{
  void* malloc(std::size_t size)
  {
    return IsMemoryShort() ? nullptr : __libc_malloc(size);
  }

  void* calloc(std::size_t count, std::size_t size)
  {
    return IsMemoryShort() ? nullptr : __libc_calloc(count, size);
  }

  void* realloc(void* memory, std::size_t size)
  {
    return IsMemoryShort() ? nullptr : __libc_realloc(memory, size);
  }

  void* aligned_alloc(std::size_t alignment, std::size_t size)
  {
    return IsMemoryShort() ? nullptr : __libc_memalign(alignment, size);
  }

  int posix_memalign(void** memory, std::size_t alignment, std::size_t size)
  {
    *memory = IsMemoryShort() ? nullptr : __libc_memalign(alignment, size);
    return *memory ? 0 : ENOMEM;
  }

  int pthread_create(
    pthread_t* thread, const pthread_attr_t* attributes, void* (*work)(void*), void* argument)
  {
    if (Fails(shortage::Of::Threads))
    {
      return EAGAIN;
    }
    ++ThreadsInTheMaking;
    MakeSlowly();
    const int failure = LibraryCreateThread(thread, attributes, work, argument);
    --ThreadsInTheMaking;
    return failure;
  }
}
#pragma GCC visibility pop

namespace shortage
{
Shortage::Shortage(Of what, std::size_t first, bool forGood)
  : What(what)
{
  Counted& counted = Counts[static_cast<std::size_t>(what)];
  counted.First = counted.Last = 0;
  counted.Calls = 0;
  counted.First = first;
  counted.Last = forGood ? std::numeric_limits<std::size_t>::max() : first;
}

Shortage::~Shortage()
{
  Counted& counted = Counts[static_cast<std::size_t>(this->What)];
  counted.Last = 0;
  counted.First = 0;
}

std::size_t Shortage::Calls() const
{
  return Counts[static_cast<std::size_t>(this->What)].Calls;
}

SlowThreads::SlowThreads()
{
  IsSeen = false;
  AreThreadsSlow = true;
}

SlowThreads::~SlowThreads()
{
  AreThreadsSlow = false;
}

void SlowThreads::AwaitOne() const
{
  while (!this->IsOneInTheMaking())
  {
    sched_yield();
  }
  IsSeen = true;
}

bool SlowThreads::IsOneInTheMaking() const
{
  return ThreadsInTheMaking > 0;
}
} // namespace shortage
