// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/ThreadLocals.h"

#include <cstdlib>
#include <exception>
#include <mpfr.h>
#include <new>

#ifdef __GLIBC__
#include <execinfo.h>
#endif

namespace insideout
{
namespace
{
/** This library's thread-local variables take 64 KiB of a thread, all others far less. If not
 * allocated early, the program would end when memory runs out. */
constexpr std::size_t BytesOfThreadLocals = std::size_t(128) << 10;

thread_local volatile bool IsOfThisLibrary = false;

/** OpenMP's threads end by pthread_exit, for which glibc loads an unwinder once; without memory for
 * it the program would end. backtrace() loads the same one. */
void LoadUnwinder()
{
#ifdef __GLIBC__
  void* frame = nullptr;
  [[maybe_unused]] static const int loaded = backtrace(&frame, 1);
#endif
}
} // namespace

void AllocateThreadLocals()
{
  if (!AllocateThreadLocalsOfTeam())
  {
    throw std::bad_alloc();
  }
  LoadUnwinder();
  IsOfThisLibrary = true; // and all others with it
}

bool AllocateThreadLocalsOfTeam()
{
  // Not by operator new: it throws internally, and throwing takes a thread-local variable.
  void* volatile memory = std::malloc(BytesOfThreadLocals);
  std::free(memory);
  if (!memory)
  {
    return false;
  }
  // For the C++ library's exceptions, and for MPFR.
  [[maybe_unused]] const volatile auto touched = std::uncaught_exceptions() + mpfr_get_emin();
  return true;
}
} // namespace insideout
