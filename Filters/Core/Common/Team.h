// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

namespace insideout
{
/** Four for each of the machine's processors: more would only take memory. */
int MostThreads();

/** OpenMP's number of threads (OMP_NUM_THREADS, omp_set_num_threads), limited by MostThreads and
 * the host's limit. */
int AllowedThreads();

/**
 * Set the function that AllowedThreads asks, on the thread that gathers a team, for the host
 * program's limit of threads.
 *
 * @param[in] limit returns 0 for none
 */
void SetHostLimit(int (*limit)());

/** A message that more threads are requested than MostThreads; empty if that is not so. */
std::string TooManyThreads();

/**
 * The number of threads that pays off for work of this many nanoseconds on one thread. At most
 * AllowedThreads; one within a team.
 */
int TeamSize(double nanoseconds);

/**
 * Call work() on this thread and on up to threads - 1 others, and return when all is done. The
 * calls share the work, chunk by chunk, and must not throw.
 *
 * Threads that start when no work is left are not waited for, and no thread spins. OpenMP's teams
 * do both: next to two busy processes on two processors, a loop of 0.05 ms took 13 ms with OpenMP
 * and 0.06 ms with this. Requesting a thread costs 0.01 ms, busy or not.
 *
 * If the system provides no more threads, or no memory for them, the existing ones do the work.
 * Threads end with the work, so that a process forked between two calls lacks none.
 *
 * @throws Error Forked in a process forked during the work
 */
void WorkAsTeam(int threads, const std::function<void()>& work);

/**
 * For tests: while it lives, all work is done on all threads, and none of them starts before all
 * have arrived, so that small surfaces behave like large ones. Not to be created during work.
 */
class WholeTeams
{
public:
  WholeTeams();
  ~WholeTeams();
  WholeTeams(const WholeTeams&) = delete;
  WholeTeams& operator=(const WholeTeams&) = delete;
};
} // namespace insideout
