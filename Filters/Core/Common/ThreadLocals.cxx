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
/** Those of this library take 64 KiB of a thread, and all others far less.
 * Without them allocated early the program would end where memory does. */
constexpr std::size_t BytesOfThreadLocals = std::size_t(128) << 10;

thread_local volatile bool IsOfThisLibrary = false;

/** OpenMP's threads end by pthread_exit, for which glibc loads an unwinder once; without memory for
 * it the program would end. backtrace() takes the same one. */
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
  IsOfThisLibrary = true; // and with it come all others
}

bool AllocateThreadLocalsOfTeam()
{
  // Not by operator new: it throws, if only to itself, and to throw takes a thread-local variable.
  void* volatile memory = std::malloc(BytesOfThreadLocals);
  std::free(memory);
  if (!memory)
  {
    return false;
  }
  // The C++ library's, for exceptions, and MPFR's.
  [[maybe_unused]] const volatile auto touched = std::uncaught_exceptions() + mpfr_get_emin();
  return true;
}
} // namespace insideout
