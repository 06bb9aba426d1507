// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <csignal>
#include <cstdlib>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

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
