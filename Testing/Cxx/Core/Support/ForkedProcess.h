// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define INSIDEOUT_IS_SANITIZED
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define INSIDEOUT_IS_SANITIZED
#endif

/**
 * For tests that fork where other threads were at work just now. These may be on their way out, in
 * the sanitizer's own allocator, whose locks it leaves locked in the forked process: that hangs.
 */
#ifdef INSIDEOUT_IS_SANITIZED
#define SKIP_WHERE_FORKS_HANG() GTEST_SKIP() << "the sanitizer's locks do not survive a fork"
#else
#define SKIP_WHERE_FORKS_HANG()
#endif

namespace testprocesses
{
/** To be called in a forked process: should it hang, it ends with the test that waits for it. */
inline void EndWithParent()
{
  prctl(PR_SET_PDEATHSIG, SIGKILL);
}

/** @return whether a forked process, in which work() is called, says that it is true */
template <class Work>
bool IsTrueInChild(const Work& work)
{
  const pid_t child = fork();
  if (child == 0)
  {
    EndWithParent();
    _exit(work() ? EXIT_SUCCESS : EXIT_FAILURE);
  }
  int status = 0;
  return waitpid(child, &status, 0) == child && WIFEXITED(status) &&
    WEXITSTATUS(status) == EXIT_SUCCESS;
}
} // namespace testprocesses
